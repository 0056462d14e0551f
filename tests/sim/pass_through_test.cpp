#include "sim/pass_through.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace wale {
namespace {

/// Counter-clockwise seen from +z: its area vector is +z. The wobble makes it a loop that no plane holds.
Points ring(int corners, double wobble = 0) {
  Points points(3, corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    points.col(i) = Vec3(std::cos(angle), std::sin(angle), wobble * std::cos(2 * angle));
  }
  return points;
}

Points path(std::initializer_list<Vec3> through) {
  Points points(3, static_cast<Eigen::Index>(through.size()));
  Eigen::Index i = 0;
  for (const Vec3& point : through) points.col(i++) = point;
  return points;
}

TEST(PassThrough, CountsALegAlongTheAreaVectorAsPlusOneAndAgainstItAsMinusOne) {
  const Points up = path({{0.2, 0.1, -1}, {0.3, 0.1, 1}});
  EXPECT_EQ(signed_passes(up, ring(20)), 1);
  EXPECT_EQ(signed_passes(up.rowwise().reverse(), ring(20)), -1);
  EXPECT_EQ(signed_passes(up, ring(20).rowwise().reverse()), -1);
}

TEST(PassThrough, CountsNothingForALegBesideTheLoop) {
  EXPECT_EQ(signed_passes(path({{0.9, 0.9, -1}, {0.9, 0.9, 1}}), ring(40)), 0);
  EXPECT_EQ(signed_passes(path({{0.1, 0, 0.1}, {0.2, 0, 2}}), ring(40)), 0);
}

TEST(PassThrough, CancelsALegThatComesBack) {
  EXPECT_EQ(signed_passes(path({{0.5, 0, -1}, {0.5, 0, 1}, {-0.5, 0, 1}, {-0.5, 0.1, -1}}), ring(20)), 0);
  EXPECT_EQ(signed_passes(path({{0.5, 0, -1}, {0.5, 0, 1}, {2, 0, 1}, {2, 0, -1}, {0, 0.1, -1}, {0, 0, 1}}), ring(20)),
            2);
}

TEST(PassThrough, CountsALegThroughACornerOfTheFanOnce) {
  EXPECT_EQ(signed_passes(path({{0, 0, -1}, {0, 0, 1}}), ring(4)), 1);
  EXPECT_EQ(signed_passes(path({{0, 0, -1}, {0, 0, 0}, {0, 0, 1}}), ring(4)), 1);
  EXPECT_EQ(signed_passes(path({{0.5, 0, -1}, {0.5, 0, 0}, {0.5, 0, 1}}), ring(4)), 1);
  EXPECT_EQ(signed_passes(path({{0.5, 0, 1}, {0.5, 0, 0}, {0.5, 0, 1}}), ring(4)), 0);
}

/// Many straight legs through and beside a wobbling loop, in a random pose: the count must not depend on the pose,
/// and must be the winding number of the loop about the leg, which an angle sum gives.
TEST(PassThrough, AgreesWithTheWindingNumberInAnyPose) {
  const Points loop = ring(30, 0.4);
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
  int through = 0;
  for (int i = 0; i < 400; ++i) {
    const double radius = 0.05 + 1.4 * i / 400, angle = 2.4 * i;
    const Vec3 at(radius * std::cos(angle), radius * std::sin(angle), 0);
    double winding = 0;
    for (int k = 0; k < loop.cols(); ++k) {
      const Vec3 a = loop.col(k) - at, b = loop.col((k + 1) % loop.cols()) - at;
      winding += std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
    }
    const int expected = static_cast<int>(std::lround(winding / (2 * std::numbers::pi)));
    const Points leg = path({at + Vec3(0, 0, -2), at + Vec3(0, 0, -0.01), at + Vec3(0, 0, 2)});
    ASSERT_EQ(signed_passes(leg, loop), expected) << i;
    ASSERT_EQ(signed_passes(turn.toRotationMatrix() * leg, turn.toRotationMatrix() * loop), expected) << i;
    through += expected;
  }
  EXPECT_GT(through, 100);
  EXPECT_LT(through, 300);
}

}  // namespace
}  // namespace wale
