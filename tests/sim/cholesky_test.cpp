#include "sim/solvers/cholesky.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <Eigen/Dense>

#include "tests/support/finite_difference.hpp"
#include "tests/support/one_thread.hpp"
#include "tests/support/random_ties.hpp"

namespace wale {
namespace {

Eigen::VectorXd solved(const Cholesky& cholesky, Eigen::VectorXd x) {
  cholesky.solve(x);
  return x;
}

TEST(Cholesky, SolvesAsADenseSolverDoes) {
  for (const int points : {1, 2, 40, 300}) {
    const Stiffness K = RandomTies(points, 17, 3).matrix();
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3 * points, -1, 2);
    Eigen::MatrixXd whole = dense(K);
    whole.diagonal().array() += 0.3;
    Cholesky cholesky;
    ASSERT_TRUE(cholesky.factor(K, 0.3));
    const Eigen::VectorXd expected = whole.ldlt().solve(b);
    EXPECT_LT((solved(cholesky, b) - expected).norm(), 1e-10 * expected.norm());
  }
}

TEST(Cholesky, FollowsAPatternThatGrows) {
  RandomTies ties(60, 12, 5);
  Stiffness K = ties.matrix();
  Cholesky cholesky;
  ASSERT_TRUE(cholesky.factor(K, 1));
  ties.tie(K, 3, 55);
  ASSERT_TRUE(cholesky.factor(K, 1));
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(180);
  const Eigen::VectorXd x = solved(cholesky, b);
  Eigen::VectorXd back;
  K.multiply(x, back);
  EXPECT_LT((back + x - b).norm(), 1e-10 * b.norm());
}

constexpr int many = 6000, row = 75;  // points enough for two parts and a border

/// How far (K + shift I) x is from b, over b.
double residual(const Stiffness& K, double shift, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  Eigen::VectorXd back;
  K.multiply(x, back);
  return (back + shift * x - b).norm() / b.norm();
}

/// Of a large matrix the factor is in single precision, of which (K + shift I) x is off by as many times as that matrix
/// is stiffer in one direction than in another.
double rounding(const Stiffness& K, double shift) {
  double stiffest = 0;
  for (int i = 0; i < K.points(); ++i)
    for (const Stiffness::Entry& entry : K.row(i))
      if (entry.column == i) stiffest = std::max(stiffest, K.at(entry.slot).trace());
  return 6e-8 * (2 * stiffest + shift) / shift;
}

TEST(Cholesky, SolvesInTwoPartsAndAlongTheirBorder) {
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3 * many, -1, 2);
  for (const double shift : {0.3, 1e-3}) {
    Stiffness K = RandomTies(many, row, 3).matrix();
    Cholesky cholesky;
    ASSERT_TRUE(cholesky.factor(K, shift));
    EXPECT_LT(residual(K, shift, solved(cholesky, b), b), rounding(K, shift));
    K.scale(2);  // the same order and symbolic factor
    ASSERT_TRUE(cholesky.factor(K, shift));
    EXPECT_LT(residual(K, shift, solved(cholesky, b), b), rounding(K, shift));
  }
}

TEST(Cholesky, ConvergesToAnySolutionInSinglePrecision) {
  const Stiffness K = RandomTies(many, row, 3).matrix();
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3 * many, -1, 2);
  Cholesky cholesky;
  ASSERT_TRUE(cholesky.factor(K, 1e-3));
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size()), bent;
  for (int i = 0; i < 4; ++i) {
    K.multiply(x, bent);
    x += solved(cholesky, b - bent - 1e-3 * x);
  }
  EXPECT_LT(residual(K, 1e-3, x, b), 1e-11);
}

TEST(Cholesky, SolvesWhatFallsApartByItself) {
  Stiffness K(2 * many);
  RandomTies ties(2 * many, row, 3);
  for (int i = 0; i < 2 * many; ++i)
    for (const int j : {i + 1, i + row})
      if (j < 2 * many && i / many == j / many) ties.tie(K, i, j);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(6 * many, -1, 2);
  Cholesky cholesky;
  ASSERT_TRUE(cholesky.factor(K, 0.1));
  EXPECT_LT(residual(K, 0.1, solved(cholesky, b), b), rounding(K, 0.1));
}

TEST(Cholesky, FollowsTiesBetweenItsTwoParts) {
  RandomTies ties(many, row, 5);
  Stiffness K = ties.matrix();
  Cholesky cholesky;
  ASSERT_TRUE(cholesky.factor(K, 1));
  for (int i = 0; i + 4 * row < many; i += 7) ties.tie(K, i, many - 1 - i);
  ASSERT_TRUE(cholesky.factor(K, 1));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3 * many, -1, 2);
  EXPECT_LT(residual(K, 1, solved(cholesky, b), b), rounding(K, 1));
}

TEST(Cholesky, RefusesWhatIsNotPositiveDefinite) {
  for (const int points : {80, many}) {
    const Stiffness good = RandomTies(points, 9, 1).matrix();
    for (int at = points / 16; at < points; at += points / 8) {
      Stiffness K = good;
      Cholesky cholesky;
      EXPECT_TRUE(cholesky.factor(K, 1));
      K.add(at, at, Mat3(-1000 * Mat3::Identity()));
      EXPECT_GE(cholesky.solves_a_factor(), 0);
      EXPECT_FALSE(cholesky.factor(K, 1));
      EXPECT_EQ(cholesky.solves_a_factor(), -1) << "what failed must not serve again";
      EXPECT_TRUE(cholesky.factor(good, 1));
    }
  }
}

TEST(Cholesky, GivesTheSameBitsForAnyNumberOfThreads) {
  OneThread restore;
  for (const int points : {2000, many}) {
    const Stiffness K = RandomTies(points, 45, 7).matrix();
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3 * points, -1, 2);
    const auto with = [&](int threads) {
      omp_set_num_threads(threads);
      Cholesky cholesky;
      EXPECT_TRUE(cholesky.factor(K, 0.01));
      return solved(cholesky, b);
    };
    const Eigen::VectorXd one = with(1);
    EXPECT_EQ(with(1), one);
    EXPECT_EQ(with(2), one);
    EXPECT_EQ(with(3), one);
  }
}

TEST(Cholesky, LeavesTheThreadsOfItsCallerAsTheyAre) {
  const int levels = omp_get_max_active_levels(), threads = omp_get_max_threads();
  Cholesky cholesky;
  ASSERT_TRUE(cholesky.factor(RandomTies(40, 17, 3).matrix(), 1));
  solved(cholesky, Eigen::VectorXd::Ones(120));
  EXPECT_EQ(omp_get_max_active_levels(), levels);
  EXPECT_EQ(omp_get_max_threads(), threads);
}

}  // namespace
}  // namespace wale
