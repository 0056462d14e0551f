#include "sim/results/topology.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/sim/results/made_jersey.hpp"

namespace wale {
namespace {

TEST(Topology, FindsEveryCrossingOfAJerseyInAnyPose) {
  const testing::MadeJersey made = testing::made_jersey(4, 3);
  EXPECT_EQ(made.crossings.size(), 16U);
  EXPECT_EQ(check_crossings(made.fabric, made.crossings, made.fabric.points).found, 16);
  const Mat3 turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized().toRotationMatrix();
  EXPECT_TRUE(check_crossings(made.fabric, made.crossings, turn * made.fabric.points).intact());
}

TEST(Topology, ReversesWithTheFace) {
  const testing::MadeJersey made = testing::made_jersey(4, 3);
  Points mirrored = made.fabric.points;
  mirrored.row(2) *= -1;
  EXPECT_EQ(check_crossings(made.fabric, made.crossings, mirrored).found, 0);
}

TEST(Topology, MissesTheCrossingsOfACourseLiftedOut) {
  const testing::MadeJersey made = testing::made_jersey(4, 3);
  Points pulled = made.fabric.points;
  const Yarn& top = made.fabric.yarns.back();
  pulled.middleCols(top.first_point, top.points()).row(2).array() += 5e-3;
  const Topology topology = check_crossings(made.fabric, made.crossings, pulled);
  EXPECT_EQ(topology.expected, 16);
  EXPECT_EQ(topology.found, 8);
  EXPECT_FALSE(topology.intact());
}

TEST(Topology, OfARunIsThatOfItsWorstState) {
  EXPECT_EQ(worse({16, 16}, {16, 9}).found, 9);
  EXPECT_EQ(worse({16, 9}, {16, 16}).found, 9);
  EXPECT_EQ(worse({}, {16, 16}).expected, 16);
}

}  // namespace
}  // namespace wale
