/// Which instruction set the force kernels use.
#pragma once

#include <vector>

#include "sim/kernels/instruction_set.hpp"

namespace wale {

/// Uses another instruction set while it lives.
class Using {
 public:
  explicit Using(InstructionSet set) { set_instruction_set(set); }
  ~Using() { set_instruction_set(before_); }
  Using(const Using&) = delete;
  Using& operator=(const Using&) = delete;

 private:
  InstructionSet before_ = instruction_set();
};

/// Those of this machine that have packs.
inline std::vector<InstructionSet> packed_sets() {
  std::vector<InstructionSet> sets;
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512})
    if (supports(set)) sets.push_back(set);
  return sets;
}

}  // namespace wale
