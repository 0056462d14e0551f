#include "sim/stiffness.hpp"

#include <gtest/gtest.h>

#include "tests/support/allocations.hpp"
#include "tests/support/finite_difference.hpp"

namespace wale {
namespace {

Mat3 block(double from, double step) {
  Mat3 result;
  for (int i = 0; i < 9; ++i) result(i / 3, i % 3) = from + step * i;
  return result;
}

Mat3 symmetric(double from) {
  const Mat3 any = block(from, 1);
  return any + any.transpose();
}

/// Four points: a chain and one far block, added in no order, and one block twice.
Stiffness example() {
  Stiffness stiffness(4);
  stiffness.add(2, 3, block(1, 2));
  stiffness.add(0, 0, symmetric(3));
  stiffness.add(0, 3, block(-4, 1));
  stiffness.add(2, 2, symmetric(-7));
  stiffness.add(0, 1, block(5, -1));
  stiffness.add(2, 3, block(10, 0.5));
  return stiffness;
}

Eigen::MatrixXd expected() {
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(12, 12);
  k.block<3, 3>(6, 9) = block(1, 2) + block(10, 0.5);
  k.block<3, 3>(0, 9) = block(-4, 1);
  k.block<3, 3>(0, 3) = block(5, -1);
  k.triangularView<Eigen::StrictlyLower>() = k.transpose();
  k.block<3, 3>(0, 0) = symmetric(3);
  k.block<3, 3>(6, 6) = symmetric(-7);
  return k;
}

TEST(Stiffness, MultipliesAsTheFullSymmetricMatrix) { EXPECT_EQ(dense(example()), expected()); }

TEST(Stiffness, ListsEachBlockRowWithItsColumnsAscending) {
  const Stiffness stiffness = example();
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(12, 12);
  for (int i = 0; i < 4; ++i) {
    int before = -1;
    for (const auto& [column, slot] : stiffness.row(i)) {
      EXPECT_GT(column, before);
      before = column;
      k.block<3, 3>(3 * i, 3 * column) = column < i ? Mat3(stiffness.at(slot).transpose()) : stiffness.at(slot);
    }
  }
  EXPECT_EQ(k, expected());
}

TEST(Stiffness, KeepsItsPatternWhenClearedAndMakesSlotsOnlyForNewBlocks) {
  Stiffness stiffness = example();
  const std::size_t before = stiffness.slots();
  const int slot = stiffness.slot(0, 3);
  stiffness.clear();
  stiffness.add(0, 3, block(2, 2));
  EXPECT_EQ(stiffness.slots(), before);
  EXPECT_EQ(stiffness.slot(0, 3), slot);
  EXPECT_EQ(dense(stiffness).block(0, 9, 3, 3), block(2, 2));
  EXPECT_EQ(dense(stiffness).cwiseAbs().sum(), 2 * block(2, 2).cwiseAbs().sum());

  stiffness.slot(1, 2);
  EXPECT_GT(stiffness.slots(), before);
  EXPECT_EQ(stiffness.slot(0, 3), slot);
}

TEST(Stiffness, AsksForTheBlocksOfAnOwnerOnceAVersion) {
  Stiffness stiffness = example();
  int asked = 0;
  const auto list = [&](std::vector<int>& slots) {
    ++asked;
    slots.push_back(stiffness.slot(1, 3));
  };
  const std::vector<int> first = stiffness.places(&asked, 5, list);
  EXPECT_EQ(first, stiffness.places(&asked, 5, list));
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(first, stiffness.places(&asked, 6, list));
  EXPECT_EQ(asked, 2);
}

TEST(Stiffness, FindsARunOfBlocksWhetherTheyAreThereOrNot) {
  Stiffness stiffness = example();
  std::vector<int> run;
  stiffness.slots(0, 0, 4, run);
  ASSERT_EQ(run.size(), 4U);
  for (int j = 0; j < 4; ++j) EXPECT_EQ(run[static_cast<std::size_t>(j)], stiffness.slot(0, j));
  EXPECT_EQ(dense(stiffness), expected());
}

TEST(Stiffness, SharesItsPatternWithItsCopiesButNoValue) {
  Stiffness one = example(), other = one;
  const Eigen::MatrixXd before = dense(one);
  other.add(1, 2, block(3, 1));
  one.fit();
  EXPECT_EQ(dense(one), before);
  EXPECT_EQ(one.slots(), other.slots());
  EXPECT_EQ(one.slot(1, 2), other.slot(1, 2));
  EXPECT_EQ(dense(other) - before, dense(other).cwiseProduct((before.array() == 0).cast<double>().matrix()));
}

TEST(Stiffness, IsClearedWithoutAskingForMemory) {
  if (!test::counts_allocations()) GTEST_SKIP() << "the heap cannot be watched";
  Stiffness stiffness = example();
  stiffness.clear();
  EXPECT_EQ(test::allocations_of([&] { stiffness.clear(); }).calls, 0U);
}

}  // namespace
}  // namespace wale
