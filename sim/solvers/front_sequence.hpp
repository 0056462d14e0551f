/// In which sequence the supernodes of a part are eliminated.
#pragma once

#include <vector>

#include "sim/solvers/supernodes.hpp"

namespace wale {

/// Branch by branch, so that what waits for a parent is a stack. On top of what its branches left lie the columns of
/// the front at hand, and on top of these is made what it leaves itself. Of a supernode's branches that comes first
/// which needs most room beyond what it leaves: no other sequence of that kind needs less (Liu 1986, "On the storage
/// requirement in the out-of-core multifrontal method for sparse factorization").
class FrontSequence {
 public:
  explicit FrontSequence(const Supernodes&);

  const std::vector<int>& supernodes() const { return supernodes_; }
  /// How many branches a supernode has.
  int branches(int supernode) const { return static_cast<int>(branches_[static_cast<std::size_t>(supernode)].size()); }
  /// How many values are there at once, at most.
  std::size_t room() const { return room_; }

 private:
  std::vector<int> supernodes_;
  std::vector<std::vector<int>> branches_;
  std::size_t room_ = 0;
};

/// Values of the columns of a supernode, and of what it leaves for its parent; none if the border takes it.
std::size_t values_of_columns(const Supernodes&, int supernode);
std::size_t values_left(const Supernodes&, int supernode);

}  // namespace wale
