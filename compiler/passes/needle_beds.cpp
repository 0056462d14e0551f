#include "compiler/passes/needle_beds.hpp"

#include <algorithm>
#include <limits>

#include "compiler/passes/machine_rules.hpp"

namespace wale {

LoopStack front_to_back(const Needle& needle, const LoopStack& stack) {
  return on_back(needle) ? LoopStack(stack.rbegin(), stack.rend()) : stack;
}

NeedleBeds::NeedleBeds(const Program& program) {
  int first = std::numeric_limits<int>::max(), last = std::numeric_limits<int>::min();
  std::array<bool, 4> used{};
  const auto reach = [&](const Needle& needle) {
    // What lies farther out is refused before it is asked for.
    first = std::min(first, std::max(needle.index, -farthest_needle));
    last = std::max(last, std::min(needle.index, farthest_needle));
    used[static_cast<std::size_t>(needle.bed)] = true;
  };
  for (const Instruction& at : program.code) {
    if (!works_needle(at.op)) continue;
    reach(at.needle);
    if (at.op == Op::split) reach(at.other);
  }
  first_ = first;
  const auto width = static_cast<std::size_t>(std::max(0L, static_cast<long>(last) - first + 1));
  for (std::size_t bed = 0; bed < beds_.size(); ++bed)
    if (used[bed]) beds_[bed].resize(width);
}

std::vector<HeldLoops> NeedleBeds::held() const {
  std::vector<HeldLoops> held;
  for (std::size_t bed = 0; bed < beds_.size(); ++bed)
    for (std::size_t i = 0; i < beds_[bed].size(); ++i) {
      if (beds_[bed][i].empty()) continue;
      const Needle needle{static_cast<Bed>(bed), first_ + static_cast<int>(i)};
      held.push_back({needle, front_to_back(needle, beds_[bed][i])});
    }
  return held;
}

}  // namespace wale
