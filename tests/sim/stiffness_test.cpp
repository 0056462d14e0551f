#include "sim/stiffness.hpp"

#include <gtest/gtest.h>

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

Eigen::MatrixXd upper_triangle(const Stiffness::Compressed& c) {
  const auto n = static_cast<Eigen::Index>(c.start.size()) - 1;
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (int p = c.start[static_cast<std::size_t>(j)]; p < c.start[static_cast<std::size_t>(j) + 1]; ++p)
      k(c.row[static_cast<std::size_t>(p)], j) += c.value[static_cast<std::size_t>(p)];
  return k;
}

TEST(Stiffness, MultipliesAsTheFullSymmetricMatrix) { EXPECT_EQ(dense(example()), expected()); }

TEST(Stiffness, CompressesToItsUpperTriangleWithRowsAscending) {
  Stiffness::Compressed c;
  long version = -1;
  example().compress(c, version);
  EXPECT_EQ(upper_triangle(c), Eigen::MatrixXd(expected().triangularView<Eigen::Upper>()));
  for (std::size_t j = 0; j + 1 < c.start.size(); ++j)
    for (int p = c.start[j] + 1; p < c.start[j + 1]; ++p)
      EXPECT_LT(c.row[static_cast<std::size_t>(p) - 1], c.row[static_cast<std::size_t>(p)]);
}

TEST(Stiffness, KeepsItsPatternWhenClearedAndChangesVersionOnlyWithThePattern) {
  Stiffness stiffness = example();
  Stiffness::Compressed c;
  long version = -1;
  stiffness.compress(c, version);
  const auto rows = c.row;
  const long before = stiffness.version();

  stiffness.clear();
  stiffness.add(0, 3, block(2, 2));
  EXPECT_EQ(stiffness.version(), before);
  stiffness.compress(c, version);
  EXPECT_EQ(c.row, rows);
  EXPECT_EQ(upper_triangle(c).block(0, 9, 3, 3), block(2, 2));
  EXPECT_EQ(upper_triangle(c).cwiseAbs().sum(), block(2, 2).cwiseAbs().sum());

  stiffness.touch(1, 2);
  EXPECT_GT(stiffness.version(), before);
  stiffness.compress(c, version);
  EXPECT_EQ(version, stiffness.version());
  EXPECT_GT(c.row.size(), rows.size());
}

TEST(Stiffness, ForgetsItsPatternWhenAsked) {
  Stiffness stiffness = example();
  const long before = stiffness.version();
  stiffness.forget();
  EXPECT_GT(stiffness.version(), before);
  EXPECT_EQ(dense(stiffness), Eigen::MatrixXd::Zero(12, 12));
  stiffness.add(1, 1, symmetric(1));
  EXPECT_EQ(dense(stiffness).cwiseAbs().sum(), symmetric(1).cwiseAbs().sum());
}

}  // namespace
}  // namespace wale
