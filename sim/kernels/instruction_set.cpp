#include "sim/kernels/instruction_set.hpp"

#include <cassert>
#include <cstdlib>

namespace wale {
namespace {

constexpr InstructionSet widest_first[] = {InstructionSet::avx512, InstructionSet::avx2, InstructionSet::scalar};

InstructionSet choose() {
  const char* wanted = std::getenv("WALE_INSTRUCTIONS");
  for (const InstructionSet set : widest_first)
    if (wanted && name(set) == wanted && supports(set)) return set;
  for (const InstructionSet set : widest_first)
    if (supports(set)) return set;
  return InstructionSet::scalar;
}

InstructionSet& in_use() {
  static InstructionSet set = choose();
  return set;
}

}  // namespace

std::string_view name(InstructionSet set) {
  constexpr std::string_view names[] = {"scalar", "avx2", "avx512"};
  return names[static_cast<std::size_t>(set)];
}

bool supports(InstructionSet set) {
  if (set == InstructionSet::scalar) return true;
#if defined(__x86_64__)
  if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
#else
  return false;
#endif
}

InstructionSet instruction_set() { return in_use(); }

void set_instruction_set(InstructionSet set) {
  assert(supports(set));
  in_use() = set;
}

}  // namespace wale
