#include "compiler/passes/springs.hpp"

#include <gtest/gtest.h>

namespace wale {
namespace {

TEST(Springs, RestWhereTheirPullsBalance) {
  Springs springs(3);
  springs.towards(0, 1, 2);
  springs.between(0, 1, 3, 1);
  springs.between(1, 2, 1, 4);
  springs.towards(2, 10, 1);
  const Eigen::VectorXd x = springs.rest();
  // The four in a row stretch by 10 - 1 - 3 - 1 = 5 in all, in proportion to 1/weight.
  const double share = 5 / (1 / 2.0 + 1 + 1 / 4.0 + 1);
  EXPECT_NEAR(x(0), 1 + share / 2, 1e-12);
  EXPECT_NEAR(x(1), x(0) + 3 + share, 1e-12);
  EXPECT_NEAR(x(2), 10 - share, 1e-12);
}

TEST(Springs, WithoutContradictionKeepEveryDistance) {
  Springs springs(3);
  springs.towards(0, -2, 1e-3);
  springs.between(0, 1, 5, 1);
  springs.between(0, 2, -1, 0.1);
  springs.between(2, 1, 6, 3);
  const Eigen::VectorXd x = springs.rest();
  EXPECT_NEAR(x(0), -2, 1e-9);
  EXPECT_NEAR(x(1), 3, 1e-9);
  EXPECT_NEAR(x(2), -3, 1e-9);
}

}  // namespace
}  // namespace wale
