#include "sim/solvers/front_sequence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "sim/solvers/dissection.hpp"
#include "tests/support/random_ties.hpp"

namespace wale {
namespace {

class FrontSequenceOf : public testing::TestWithParam<int> {
 protected:
  FrontSequenceOf() {
    used_.update(K_);
    supernodes_.emplace(K_, used_, dissect(K_, used_).parts.front(), std::vector<int>());
  }

  std::vector<int> branches(int supernode) const {
    std::vector<int> found;
    for (int s = 0; s < supernode; ++s)
      if (supernodes_->parent(s) == supernode) found.push_back(s);
    return found;
  }

  /// What is needed for a supernode and all below it, whichever of its branches comes first, where `least` has that of
  /// its branches.
  std::size_t least_room(int supernode, const std::vector<std::size_t>& least) const {
    const std::size_t own = values_of_columns(*supernodes_, supernode) + values_left(*supernodes_, supernode);
    std::vector<int> some = branches(supernode);
    std::size_t best = static_cast<std::size_t>(-1);
    do {
      std::size_t waiting = 0, room = 0;
      for (const int branch : some) {
        room = std::max(room, waiting + least[static_cast<std::size_t>(branch)]);
        waiting += values_left(*supernodes_, branch);
      }
      best = std::min(best, std::max(room, waiting + own));
    } while (std::next_permutation(some.begin(), some.end()));
    return best;
  }

  const Stiffness K_ = RandomTies(GetParam(), 40, 1).matrix();
  UsedBlocks used_;
  std::optional<Supernodes> supernodes_;
};

TEST_P(FrontSequenceOf, NeedsNoMoreThanAnyOtherOfItsKind) {
  std::vector<std::size_t> least;
  for (int s = 0; s < supernodes_->count(); ++s) least.push_back(least_room(s, least));
  EXPECT_EQ(FrontSequence(*supernodes_).room(), *std::max_element(least.begin(), least.end()));
}

TEST_P(FrontSequenceOf, LeavesWhatWaitsOnAStackWithinItsRoom) {
  const FrontSequence sequence(*supernodes_);
  std::vector<int> stack;
  std::size_t waiting = 0, most = 0;
  for (const int s : sequence.supernodes()) {
    most = std::max(most, waiting + values_of_columns(*supernodes_, s) + values_left(*supernodes_, s));
    std::vector<int> popped(stack.end() - sequence.branches(s), stack.end());
    stack.resize(stack.size() - popped.size());
    for (const int branch : popped) waiting -= values_left(*supernodes_, branch);
    std::sort(popped.begin(), popped.end());
    EXPECT_EQ(popped, branches(s));
    if (supernodes_->parent(s) < 0) continue;
    stack.push_back(s);
    waiting += values_left(*supernodes_, s);
  }
  EXPECT_TRUE(stack.empty());
  EXPECT_EQ(most, sequence.room());
  std::vector<int> all = sequence.supernodes(), expected(static_cast<std::size_t>(supernodes_->count()));
  std::iota(expected.begin(), expected.end(), 0);
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, expected);
}

INSTANTIATE_TEST_SUITE_P(SomeTies, FrontSequenceOf, testing::Values(1, 150, 1000, 3000));

}  // namespace
}  // namespace wale
