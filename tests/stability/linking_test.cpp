#include "tests/stability/linking.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace wale::stability {
namespace {

/// A circle of radius 1 about `centre` in the plane of two unit vectors.
Points circle(const Vec3& centre, const Vec3& u, const Vec3& v, int pieces = 24) {
  Points points(3, pieces);
  for (int k = 0; k < pieces; ++k) {
    const double angle = 2 * std::numbers::pi * k / pieces;
    points.col(k) = centre + std::cos(angle) * u + std::sin(angle) * v;
  }
  return points;
}

const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
constexpr double exact = 1e-12;

TEST(LinkingNumber, OfTwoLinksOfAChainIsOneWithTheSignOfTheirTurn) {
  const Points ring = circle(Vec3::Zero(), x, y), through = circle(x, x, z);
  EXPECT_NEAR(std::abs(linking_number(ring, through)), 1, exact);
  EXPECT_NEAR(linking_number(ring.rowwise().reverse(), through), -linking_number(ring, through), exact);
  EXPECT_NEAR(linking_number(through, ring), linking_number(ring, through), exact);
}

TEST(LinkingNumber, OfRingsBesideOrBehindEachOtherIsZero) {
  const Points ring = circle(Vec3::Zero(), x, y);
  for (const Vec3& centre : {Vec3(2.1 * x), Vec3(0.1 * z), Vec3(x + 1.2 * y + 0.1 * z)})
    EXPECT_NEAR(linking_number(ring, circle(centre, x, y)), 0, exact);
}

/// A (2, 2k) torus link: a ring and a curve that winds k times round it.
TEST(LinkingNumber, CountsEveryTurnOfAWinding) {
  const Points ring = circle(Vec3::Zero(), x, y, 96);
  for (const int turns : {-3, -1, 0, 2, 5}) {
    Points winding(3, 200);
    for (int k = 0; k < 200; ++k) {
      const double angle = 2 * std::numbers::pi * k / 200, at = turns * angle;
      winding.col(k) = (1 + 0.3 * std::cos(at)) * (std::cos(angle) * x + std::sin(angle) * y) + 0.3 * std::sin(at) * z;
    }
    EXPECT_NEAR(std::abs(linking_number(ring, winding)), std::abs(turns), 1e-11) << turns;
  }
}

TEST(LinkingNumber, StaysWhenOnePassesTheOtherAtAHairsBreadthAndChangesWhenItPassesThrough) {
  const Points ring = circle(Vec3::Zero(), x, y);
  EXPECT_NEAR(std::abs(linking_number(ring, circle((2 - 1e-9) * x, x, z))), 1, 1e-9);
  EXPECT_NEAR(linking_number(ring, circle((2 + 1e-9) * x, x, z)), 0, 1e-9);
}

}  // namespace
}  // namespace wale::stability
