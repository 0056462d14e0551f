#include "sim/mount.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace wale {
namespace {

constexpr double gauge_length = 20e-3;  // m

std::vector<Mounted> mount(const std::function<double(double)>& force, int samples) {
  std::vector<Mounted> tried;
  for (int i = 0; i < samples; ++i) {
    const double travel = next_travel(tried, gauge_length);
    tried.push_back({travel, force(travel)});
  }
  return tried;
}

/// A J-shaped curve, through zero where the fabric is `slack` longer than between the grips.
double j_shaped(double travel, double slack) { return 0.5 * std::expm1((travel - slack) / 1e-3); }

TEST(Mount, ReadsTheClosedGripsFirst) { EXPECT_EQ(next_travel({}, gauge_length), 0); }

TEST(Mount, FindsTheLengthWithoutForceFromEitherSide) {
  for (const double slack : {0.9e-3, -0.3e-3}) {
    const auto tried = mount([&](double travel) { return j_shaped(travel, slack); }, 12);
    EXPECT_NEAR(tried.back().travel, slack, 1e-6) << slack;
  }
}

TEST(Mount, GoesAtMostTwoPercentAtATime) {
  double before = 0;
  for (const Mounted& each : mount([](double travel) { return travel - 1; }, 12)) {
    EXPECT_LE(each.travel - before, 0.02 * gauge_length * (1 + 1e-12));
    before = each.travel;
  }
  EXPECT_GT(before, 0.1 * gauge_length);
}

/// Settling, a fabric may push where it pulls a moment later: that is no bracket.
TEST(Mount, ForgetsABracketThatTheFabricHasLeft) {
  const std::vector<Mounted> tried{{0.7e-4, -0.1}, {0.6e-4, 0.2}};
  EXPECT_LT(next_travel(tried, gauge_length), 0.6e-4);
}

TEST(Mount, StaysWhereThePullIsNoMoreThanCanBeRead) {
  EXPECT_EQ(next_travel({{1e-4, -0.5}, {2e-4, 0.01}}, gauge_length, 0.01), 2e-4);
  EXPECT_LT(next_travel({{1e-4, -0.5}, {2e-4, 0.011}}, gauge_length, 0.01), 2e-4);
}

TEST(Mount, StaysWhereNothingPulls) { EXPECT_EQ(next_travel({{1e-4, -0.5}, {2e-4, 0}}, gauge_length), 2e-4); }

}  // namespace
}  // namespace wale
