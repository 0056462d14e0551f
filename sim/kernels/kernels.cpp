#include "sim/kernels/kernels.hpp"

#include "sim/kernels/tables.hpp"

namespace wale {

const Kernels& kernels() { return kernels(instruction_set()); }

const Kernels& kernels(InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return avx512_kernels;
  if (set == InstructionSet::avx2) return avx2_kernels;
#endif
  static_cast<void>(set);
  return scalar_kernels;
}

}  // namespace wale
