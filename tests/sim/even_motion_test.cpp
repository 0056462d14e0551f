#include "sim/solvers/even_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "tests/support/make_fabric.hpp"

namespace wale {
namespace {

Points scattered() {
  Points q = Points::Zero(3, 50);
  shake(q, 10e-3, 4);
  return q;
}

Points strained_turned_and_shifted(const Points& q) {
  Mat3 strain;
  strain << 0.1, 0.02, 0, 0.02, -0.05, 0, 0, 0, 0.3;
  const Mat3 by = Eigen::AngleAxisd(0.2, Vec3(1, 2, -1).normalized()) * (Mat3::Identity() + strain);
  return (by * q).colwise() + Vec3(1e-3, -2e-3, 5e-3) - q;
}

TEST(EvenMotion, IsAllOfAStrainATurnAndAShift) {
  const Points q = scattered(), move = strained_turned_and_shifted(q);
  EXPECT_LT(largest_motion(even_motion(q, move), move), 1e-12);
  EXPECT_LT(uneven_motion(q, move), 1e-12);
}

TEST(EvenMotion, IsLittleOfWhatOnePointOfManyDoes) {
  const Points q = scattered();
  Points move = strained_turned_and_shifted(q);
  const Points even = move;
  move.col(7) += Vec3(0, 0, 1e-3);
  EXPECT_LT(largest_motion(even_motion(q, move), even), 0.2e-3);
  EXPECT_NEAR(uneven_motion(q, move), 1e-3, 0.2e-3);
}

TEST(EvenMotion, LeavesFlatYarnsFlatThatMoveInTheirPlane) {
  Points q = scattered();
  q.row(2).setZero();
  Points move = 0.1 * q;
  EXPECT_LT(largest_motion(even_motion(q, move), move), 1e-12);
}

constexpr int rows = 100, points = 100;
constexpr double apart = 1e-3;  // m

/// Straight yarns side by side, as many as there are points in each.
Fabric sheet() {
  Fabric fabric;
  fabric.points.resize(3, rows * points);
  for (int row = 0; row < rows; ++row)
    for (int k = 0; k < points; ++k) fabric.points.col(row * points + k) = apart * Vec3(k, row, 0);
  for (int row = 0; row < rows; ++row) {
    Yarn yarn;
    yarn.first_point = row * points;
    yarn.segments = points - 3;
    fabric.yarns.push_back(yarn);
  }
  return fabric;
}

template <class At>
Points moved(const Points& q, const At& at) {
  Points move(3, q.cols());
  for (Eigen::Index k = 0; k < q.cols(); ++k) move.col(k) = at(q.col(k));
  return move;
}

TEST(UnevenMotionNearby, IsNoneOfAStrainAndATurn) {
  const Fabric fabric = sheet();
  const Points move =
      moved(fabric.points, [](const Vec3& at) { return Vec3(0.1 * at.x() + 0.02 * at.y(), -0.05 * at.y(), 3e-3); });
  EXPECT_LT(uneven_motion_nearby(fabric, fabric.points, move), 1e-12);
}

TEST(UnevenMotionNearby, IsLittleOfAWaveAsLongAsTheFabric) {
  const Fabric fabric = sheet();
  const double length = rows * apart, height = 1e-3;
  const Points move =
      moved(fabric.points, [&](const Vec3& at) { return Vec3(0, 0, height * std::cos(6.283 * at.x() / length)); });
  const double of_all = uneven_motion(fabric.points, move), nearby = uneven_motion_nearby(fabric, fabric.points, move);
  EXPECT_GT(of_all, 0.9 * height);
  EXPECT_LT(nearby, 0.2 * height);
  // Between neighbours the wave bends by this much.
  EXPECT_GT(nearby, height * std::pow(6.283 / length, 2) * apart * apart / 2);
}

TEST(UnevenMotionNearby, IsAllOfWhatOnePointDoes) {
  const Fabric fabric = sheet();
  Points move = moved(fabric.points, [](const Vec3& at) { return Vec3(0.1 * at.x(), 0, 0); });
  move.col(5050) += Vec3(0, 0, 1e-3);
  EXPECT_NEAR(uneven_motion_nearby(fabric, fabric.points, move), 1e-3, 0.05e-3);
}

/// Turned over, a few yarns come to the other side of each other, though all by one even motion.
TEST(UnevenMotionNearby, IsMuchWhereNeighboursTurnOver) {
  const Fabric fabric = sheet();
  Points q = fabric.points;
  for (int k = 0; k < points; ++k) q.col(k).y() -= 20e-3;  // the first yarn lies by itself
  for (int k = 0; k < points; ++k) q.col(k).z() = k % 2 == 0 ? 0.1e-3 : -0.1e-3;
  Points move = Points::Zero(3, q.cols());
  move.row(2).head(points) = -2 * q.row(2).head(points);
  EXPECT_GT(uneven_motion_nearby(fabric, q, move), 0.15e-3);
}

TEST(UnevenMotionNearby, IsThatOfAllWhereTheFabricIsSmall) {
  Fabric fabric = sheet();
  fabric.points *= 1e-2;
  Points move = Points::Zero(3, fabric.points.cols());
  shake(move, 1e-3, 7);
  EXPECT_DOUBLE_EQ(uneven_motion_nearby(fabric, fabric.points, move), uneven_motion(fabric.points, move));
}

}  // namespace
}  // namespace wale
