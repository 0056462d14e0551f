/// Which blocks of a Stiffness are other than zero.
#pragma once

#include <vector>

#include "sim/stiffness.hpp"

namespace wale {

/// Most listed pairs of yarn do not touch, and to leave their blocks out of a factor halves its work. Kept as long as
/// no block is other than zero that was zero.
class UsedBlocks {
 public:
  /// Looks at the values of K. True if the pattern changed.
  bool update(const Stiffness& K);
  /// Whether the pattern has a block: those on the diagonal always.
  bool has(int point, const Stiffness::Entry& entry) const {
    return entry.column == point || used_[static_cast<std::size_t>(entry.slot)];
  }

 private:
  std::vector<char> used_;  // by slot
  bool looked_ = false;
};

}  // namespace wale
