#include "sim/solvers/surroundings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/make_fabric.hpp"

namespace wale {
namespace {

TEST(Surroundings, AreAllWithinReachAndNoneMuchFurther) {
  Points q = Points::Zero(3, 4000);
  shake(q, 20e-3, 3);
  const std::vector<int> of{17, 1234};
  const double reach = 4e-3;
  const std::vector<int> found = surroundings(q, of, reach);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  for (int i = 0; i < q.cols(); ++i) {
    const auto from = [&](int point) { return (q.col(i) - q.col(point)).eval(); };
    const bool is_found = std::binary_search(found.begin(), found.end(), i);
    for (const int point : of) EXPECT_TRUE(is_found || from(point).norm() > reach) << i;
    EXPECT_TRUE(!is_found || std::any_of(of.begin(), of.end(), [&](int point) {
      return from(point).cwiseAbs().maxCoeff() < 2 * reach;
    })) << i;
  }
}

TEST(Surroundings, OfNothingAreNothing) { EXPECT_TRUE(surroundings(Points::Random(3, 10), {}, 1e-3).empty()); }

}  // namespace
}  // namespace wale
