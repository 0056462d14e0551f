#include "sim/results/topology.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "sim/clasps.hpp"
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

/// Sides from head to head, as the compiler demands them, of the loops that have a neighbour there.
std::vector<Crossing> head_to_head(const testing::MadeJersey& made, int per_loop) {
  std::vector<Crossing> crossings;
  const int segments = made.gauge.wales * per_loop;
  for (int wale = 0; wale < made.gauge.wales; ++wale) {
    const int below = wale * per_loop, above = segments + below, half = per_loop / 2;
    if (wale > 0) crossings.push_back({above - half, above + half - 1, below, below + per_loop - 1, -1});
    if (wale + 1 < made.gauge.wales)
      crossings.push_back({above + half, above + per_loop + half - 1, below, below + per_loop - 1, +1});
  }
  return crossings;
}

TEST(Topology, FollowsYarnThatSlidesThroughTheFabric) {
  constexpr int per_loop = 12, loops = 7;
  const testing::MadeJersey made = testing::made_jersey(loops, 2, per_loop);
  std::vector<Crossing> crossings;
  for (const Crossing& at : head_to_head(made, per_loop))
    if (at.side_first - loops * per_loop >= 2 * per_loop && at.side_last - loops * per_loop < (loops - 2) * per_loop)
      crossings.push_back(at);
  ASSERT_GE(crossings.size(), 4U);
  Clasps clasps(made.fabric, crossings);
  // One loop and a half through the lower course, step by step: each control point takes the place of the one before.
  const Yarn& low = made.fabric.yarns.front();
  Points slid = made.fabric.points;
  for (int step = 1; step <= 9; ++step) {
    for (int k = 0; k < low.points(); ++k)
      slid.col(low.first_point + k) = testing::loop_point(-2 + 4.0 * (k - 1 - 2 * step) / per_loop, made.diameter);
    EXPECT_TRUE(tally(clasps.follow(slid)).intact()) << 2 * step << " segments";
  }
  EXPECT_FALSE(check_crossings(made.fabric, crossings, slid).intact()) << "at once it is too far to follow";
}

TEST(Topology, MissesOneLoopPushedOutBetweenItsNeighbours) {
  constexpr int per_loop = 12, pushed = 2;
  const testing::MadeJersey made = testing::made_jersey(5, 2, per_loop);
  Points torn = made.fabric.points;
  const Yarn& top = made.fabric.yarns.back();
  // Back out the way it came: through the loop below from the front to behind.
  for (int i = 0; i <= per_loop; ++i)
    torn(2, top.first_point + 1 + pushed * per_loop + i) -= 1.5e-3 * std::min({1.0, i / 2.0, (per_loop - i) / 2.0});
  const std::vector<Crossing> crossings = head_to_head(made, per_loop);
  EXPECT_TRUE(check_crossings(made.fabric, crossings, made.fabric.points).intact());
  EXPECT_EQ(check_crossings(made.fabric, crossings, torn).found, static_cast<long>(crossings.size()) - 2);
}

TEST(Topology, OfARunIsThatOfItsWorstState) {
  EXPECT_EQ(worse({16, 16}, {16, 9}).found, 9);
  EXPECT_EQ(worse({16, 9}, {16, 16}).found, 9);
  EXPECT_EQ(worse({}, {16, 16}).expected, 16);
}

}  // namespace
}  // namespace wale
