#include "sim/net_crossing.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace wale {
namespace {

constexpr double pi = std::numbers::pi;

/// A half loop open downwards: up at x = -1, round in a half circle about the origin, and down at x = 1.
Points half_loop() {
  constexpr int steps = 41;
  Points loop(3, steps + 2);
  loop.col(0) = Vec3(-1, -3, 0);
  for (int k = 0; k < steps; ++k) {
    const double angle = pi * (1 - k / (steps - 1.0));
    loop.col(k + 1) = Vec3(std::cos(angle), std::sin(angle), 0);
  }
  loop.rightCols<1>() = Vec3(1, -3, 0);
  return loop;
}

/// A strand along y that crosses the head of half_loop(), at depth `z`.
Points strand(double z) {
  Points strand(3, 2);
  strand << 0.2, 0.21, -2, 2, z, z;
  return strand;
}

/// A half loop open upwards that comes down before the head of half_loop(), goes through it and up behind; or, with
/// `front` -1, the other way.
Points clasped_loop(double front) {
  Points loop(3, 5);
  loop.col(0) = Vec3(-0.5, 3, 0.5 * front);
  loop.col(1) = Vec3(-0.5, 0.3, 0.5 * front);
  loop.col(2) = Vec3(-0.02, 0.07, 0);
  loop.col(3) = Vec3(0.5, 0.31, -0.5 * front);
  loop.col(4) = Vec3(0.52, 3, -0.5 * front);
  return loop;
}

/// A side that crosses half_loop() twice: from the left, over its left leg, then back out behind its head; or mirrored.
Points hooked_side(double front) {
  Points side(3, 4);
  side.col(0) = Vec3(-2, -0.52, front);
  side.col(1) = Vec3(-0.3, -0.5, front);
  side.col(2) = Vec3(-0.2, 0.2, -front);
  side.col(3) = Vec3(-0.21, 2, -front);
  return side;
}

Mat3 some_turn() { return Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized().toRotationMatrix(); }

TEST(NetCrossing, OfOneCrossingIsTheTurnFromTheUpperToTheLower) {
  Points right(3, 2), up(3, 2);
  right << -1, 1, 0, 0.01, 1, 1;
  up << 0, 0.01, -1, 1, 0, 0;
  EXPECT_EQ(net_crossing(right, up, Vec3::UnitZ()), 1);
  EXPECT_EQ(net_crossing(up, right, Vec3::UnitZ()), 1);
  right.row(2) *= -1;
  EXPECT_EQ(net_crossing(right, up, Vec3::UnitZ()), -1);
  EXPECT_EQ(net_crossing(right.rowwise().reverse(), up, Vec3::UnitZ()), 1);
}

TEST(NetCrossing, OfTwoHalfLoopsThatClaspIsTwoEitherWay) {
  EXPECT_EQ(std::abs(net_crossing(clasped_loop(1), half_loop(), Vec3::UnitZ())), 2);
  EXPECT_EQ(net_crossing(clasped_loop(1), half_loop(), Vec3::UnitZ()),
            -net_crossing(clasped_loop(-1), half_loop(), Vec3::UnitZ()));
}

TEST(NetCrossing, OfASidePulledThroughALoopIsTwoEitherWay) {
  EXPECT_EQ(net_crossing(hooked_side(1), half_loop(), Vec3::UnitZ()), 2);
  EXPECT_EQ(net_crossing(hooked_side(-1), half_loop(), Vec3::UnitZ()), -2);
}

TEST(NetCrossing, OfAStrandThatOnlyLiesAcrossIsZero) {
  Points across(3, 2);
  across << -2, 2, -0.5, -0.51, 1, 1;
  EXPECT_EQ(net_crossing(across, half_loop(), Vec3::UnitZ()), 0);
}

TEST(NetCrossing, StaysWhenYarnsAndViewTurnTogetherAndFromBehind) {
  const Points side = hooked_side(1), loop = half_loop();
  EXPECT_EQ(net_crossing(some_turn() * side, some_turn() * loop, some_turn() * Vec3::UnitZ()), 2);
  EXPECT_EQ(net_crossing(side, loop, -Vec3::UnitZ()), 2);
  EXPECT_EQ(net_crossing(loop, side, Vec3::UnitZ()), 2);
}

TEST(NetCrossing, StaysWhileNothingPassesThrough) {
  for (double x = -0.55; x < 0.6; x += 0.1)
    for (double y = -0.4; y < 0.5; y += 0.1) {
      const Points moved = hooked_side(1).colwise() + Vec3(x, y, 0.3 * x);
      EXPECT_EQ(net_crossing(moved, half_loop(), Vec3(0.1 * y, 0.1 * x, 1)), 2) << x << ", " << y;
    }
}

TEST(NetCrossing, ChangesByTwoWhenAStrandPassesThrough) {
  EXPECT_EQ(net_crossing(strand(-1), half_loop(), Vec3::UnitZ()), 1);
  EXPECT_EQ(net_crossing(strand(1), half_loop(), Vec3::UnitZ()), -1);
}

TEST(NetCrossing, CountsACrossingAtACornerOnce) {
  Points bent(3, 3), straight(3, 3);
  bent << 0, 0, 0, -1, 0, 1, 1, 1, 1;
  straight << -1, 0, 1, 0, 0, 0, 0, 0, 0;
  EXPECT_EQ(std::abs(net_crossing(bent, straight, Vec3::UnitZ())), 1);
}

TEST(AreaVector, IsTheAreaOfAClosedLoopTimesItsNormal) {
  constexpr int steps = 400;
  Points circle(3, steps);
  for (int k = 0; k < steps; ++k) {
    const double angle = 2 * pi * k / steps;
    circle.col(k) = Vec3(2 * std::cos(angle), 2 * std::sin(angle), 5);
  }
  EXPECT_NEAR((area_vector(circle) - Vec3(0, 0, 4 * pi)).norm(), 0, 1e-3 * 4 * pi);
  const Points turned = some_turn() * circle;
  EXPECT_NEAR((area_vector(turned) - some_turn() * area_vector(circle)).norm(), 0, 1e-12);
}

TEST(AreaVector, IsClosedByTheChordAndDoesNotDependOnTheOrigin) {
  const Points loop = half_loop();
  const Points moved = loop.colwise() + Vec3(3, -7, 11);
  EXPECT_NEAR(area_vector(loop).z(), -(6 + pi / 2), 2e-3);
  EXPECT_NEAR((area_vector(loop) - area_vector(moved)).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace wale
