#include "sim/solvers/clearance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

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

}  // namespace
}  // namespace wale
