#include "sim/solvers/part_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "tests/support/finite_difference.hpp"
#include "tests/support/random_ties.hpp"

namespace wale {
namespace {

constexpr int points = 240;
constexpr double shift = 0.1;

/// Every tenth point is the border, so that supernodes reach it from all sides.
struct Split {
  std::vector<int> part, border;
  std::vector<Eigen::Index> own, at_border;  // coordinates

  Split() {
    for (int i = 0; i < points; ++i) {
      (i % 10 == 7 ? border : part).push_back(i);
      for (int axis = 0; axis < 3; ++axis) (i % 10 == 7 ? at_border : own).push_back(3 * i + axis);
    }
  }
};

class OfPart : public ::testing::TestWithParam<Precision> {
 protected:
  /// What a vector is off by that the factor has a part in: see Precision.
  double tolerance() const { return GetParam() == Precision::double_ ? 1e-12 : 1e-5; }

  Split split;
  Stiffness K = RandomTies(points, 13, 3).matrix();
  UsedBlocks used = [this] {
    UsedBlocks blocks;
    blocks.update(K);
    return blocks;
  }();
  Eigen::MatrixXd whole = dense(K) + shift * Eigen::MatrixXd::Identity(3 * points, 3 * points);
  Eigen::MatrixXd A = whole(split.own, split.own), C = whole(split.at_border, split.own);
  LowerTriangle lost{C.rows()};  // by the border
};

INSTANTIATE_TEST_SUITE_P(InEither, OfPart, ::testing::Values(Precision::single_, Precision::double_));

TEST_P(OfPart, TakesFromTheBorderTheSameInEitherPrecision) {
  PartFactor of(K, used, split.part, split.border, GetParam());
  ASSERT_TRUE(of.factor(K, shift, used, lost));
  const Eigen::MatrixXd expected = -C * A.ldlt().solve(C.transpose());
  Eigen::MatrixXd off = -expected;
  lost.add_to(off);
  off.triangularView<Eigen::StrictlyUpper>().setZero();
  EXPECT_LT(off.norm(), 1e-12 * expected.norm()) << "what is passed on is not rounded";
}

TEST_P(OfPart, EliminatesAndPutsBack) {
  PartFactor of(K, used, split.part, split.border, GetParam());
  ASSERT_TRUE(of.factor(K, shift, used, lost));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3 * points, -1, 2);
  Eigen::VectorXd at_border = Eigen::VectorXd::Zero(C.rows());
  of.forward(b, at_border);
  const Eigen::VectorXd passed_on = -C * A.ldlt().solve(Eigen::VectorXd(b(split.own)));
  EXPECT_LT((at_border - passed_on).norm(), tolerance() * passed_on.norm());

  const Eigen::VectorXd given = Eigen::VectorXd::LinSpaced(C.rows(), 3, -1);
  Eigen::VectorXd x = b;
  of.backward(given, x);
  const Eigen::VectorXd expected = A.ldlt().solve(Eigen::VectorXd(b(split.own)) - C.transpose() * given);
  EXPECT_LT((x(split.own) - expected).norm(), tolerance() * expected.norm());
  EXPECT_EQ(x(split.at_border), b(split.at_border)) << "which is not the part's";
}

TEST_P(OfPart, SaysWhatIsNotPositiveDefinite) {
  PartFactor of(K, used, split.part, split.border, GetParam());
  for (const int at : {0, 100, 238}) {
    Stiffness bad = K;
    bad.add(at, at, Mat3(-1000 * Mat3::Identity()));
    EXPECT_FALSE(of.factor(bad, shift, used, lost)) << at;
    EXPECT_TRUE(of.factor(K, shift, used, lost)) << "after " << at;
  }
}

/// The factor of a full matrix is a triangle; panels eight points wide hold half of their diagonal blocks in vain.
TEST(PartFactor, KeepsLittleAboveTheDiagonal) {
  constexpr int few = 100;
  RandomTies ties(few, 1, 1);
  Stiffness K(few);
  for (int i = 0; i < few; ++i)
    for (int j = i + 1; j < few; ++j) ties.tie(K, i, j);
  UsedBlocks used;
  used.update(K);
  std::vector<int> all(few);
  for (int i = 0; i < few; ++i) all[static_cast<std::size_t>(i)] = i;
  const PartFactor of(K, used, all, {}, Precision::single_);
  EXPECT_GE(of.values(), 3 * few * (3 * few + 1) / 2);
  EXPECT_LE(of.values(), 3 * few * (3 * few + 24) / 2);
}

}  // namespace
}  // namespace wale
