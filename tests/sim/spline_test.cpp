#include "sim/spline.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wale {
namespace {

/// B(s) of model.md item 1, written out again.
double bump(double s) {
  s = std::abs(s);
  return s < 1 ? 2.0 / 3 - s * s + s * s * s / 2 : s < 2 ? std::pow(2 - s, 3) / 6 : 0;
}

TEST(Spline, IsTheCubicBSplineCentredOnEachControlPoint) {
  for (double s = 0; s <= 1; s += 1.0 / 64) {
    const Basis b = basis(s);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(b.value[static_cast<std::size_t>(k)], bump(s - (k - 1)), 1e-15) << s << k;
  }
  EXPECT_DOUBLE_EQ(basis(0).value[1], 2.0 / 3);
}

TEST(Spline, SumsToOneAndItsSlopesToNothing) {
  for (double s = 0; s <= 1; s += 1.0 / 64) {
    const Basis b = basis(s);
    double value = 0, first = 0, second = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      value += b.value[k];
      first += b.first[k];
      second += b.second[k];
    }
    EXPECT_NEAR(value, 1, 1e-15);
    EXPECT_NEAR(first, 0, 1e-15);
    EXPECT_NEAR(second, 0, 1e-14);
  }
}

TEST(Spline, HasTwoContinuousSlopesFromOneSegmentToTheNext) {
  const Basis end = basis(1), start = basis(0);
  for (std::size_t k = 0; k < 4; ++k) {
    const bool shared = k > 0;  // control point k of one segment is k - 1 of the next
    EXPECT_NEAR(end.value[k], shared ? start.value[k - 1] : 0, 1e-15);
    EXPECT_NEAR(end.first[k], shared ? start.first[k - 1] : 0, 1e-15);
    EXPECT_NEAR(end.second[k], shared ? start.second[k - 1] : 0, 1e-15);
  }
}

TEST(Spline, HasTheSlopesThatDifferencesGive) {
  const double h = 1e-4;
  for (double s = 0.1; s < 0.95; s += 0.1) {
    const Basis below = basis(s - h), at = basis(s), above = basis(s + h);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(at.first[k], (above.value[k] - below.value[k]) / (2 * h), 1e-8);
      EXPECT_NEAR(at.second[k], (above.first[k] - below.first[k]) / (2 * h), 1e-8);
    }
  }
}

TEST(Gauss, IntegratesEveryPowerUpToTwiceItsNodesLessOne) {
  for (int count = 1; count <= 5; ++count) {
    ASSERT_EQ(gauss(count).size(), static_cast<std::size_t>(count));
    for (int power = 0; power <= 2 * count; ++power) {
      double sum = 0;
      for (const GaussNode& node : gauss(count)) sum += node.weight * std::pow(node.s, power);
      if (power < 2 * count)
        EXPECT_NEAR(sum, 1.0 / (power + 1), 1e-15) << count << " nodes, power " << power;
      else
        EXPECT_GT(std::abs(sum - 1.0 / (power + 1)), 1e-7) << count << " nodes cannot do power " << power;
    }
  }
}

}  // namespace
}  // namespace wale
