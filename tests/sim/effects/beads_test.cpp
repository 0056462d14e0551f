// The list of near segments, renewed where something has moved.
#include "sim/effects/beads.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/make_fabric.hpp"

namespace wale {
namespace {

constexpr double sampling = 0.03, screening = 1.6, skin = 0.2;

/// Whether two beads touch, asked of each two.
bool touch(const Beads& beads, const SegmentPair& pair) {
  const double d = beads.diameter(pair.a, pair.b);
  for (int i = 0; i < beads.count(pair.a); ++i)
    for (int j = 0; j < beads.count(pair.b); ++j)
      if (!beads.screened(pair, i, j) && (beads.position(pair.a, i) - beads.position(pair.b, j)).norm() < d)
        return true;
  return false;
}

std::vector<SegmentPair> touching(const Beads& beads) {
  std::vector<SegmentPair> found;
  for (int a = 0; a < beads.fabric().segment_count(); ++a)
    for (int b = a + 1; b < beads.fabric().segment_count(); ++b)
      if (touch(beads, {a, b, 0})) found.push_back({a, b, 0});
  return found;
}

/// Moves five points in a row of one yarn.
void pull_at(const Fabric& fabric, std::mt19937& random, Points& q) {
  std::uniform_int_distribution<std::size_t> any_yarn(0, fabric.yarns.size() - 1);
  const Yarn& yarn = fabric.yarns[any_yarn(random)];
  std::uniform_int_distribution<int> any_point(0, yarn.points() - 5);
  std::uniform_real_distribution<double> by(-0.25e-3, 0.25e-3);
  q.middleCols<5>(yarn.first_point + any_point(random)).colwise() += Vec3(by(random), by(random), by(random));
}

TEST(BeadList, HasAllThatTouchWhereverTheYarnWasPulled) {
  const Fabric fabric = woven_yarns(4, 24, 7);
  Beads beads(fabric, sampling, screening, skin);
  std::mt19937 random(3);
  Points q = fabric.points;
  beads.prepare(q);
  const std::vector<SegmentPair> before = touching(beads);
  for (int pull = 0; pull < 200; ++pull) {
    pull_at(fabric, random, q);
    beads.prepare(q);
    const std::vector<SegmentPair>&pairs = beads.pairs(), expected = touching(beads);
    ASSERT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
    ASSERT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end());
    ASSERT_TRUE(std::includes(pairs.begin(), pairs.end(), expected.begin(), expected.end())) << "pull " << pull;
  }
  EXPECT_NE(touching(beads), before);
}

TEST(BeadList, DropsWhatHasGoneAndKeepsWhatStayed) {
  Fabric fabric;
  fabric.materials = {Material{}};
  const double l = 0.6e-3;
  for (int row = 0; row < 8; ++row) add_yarn(fabric, straight_points({0, row * l, 0}, {24 * l, row * l, 0}, 24), l);
  Beads beads(fabric, sampling, screening, skin);
  Points q = fabric.points;
  beads.prepare(q);
  const std::vector<SegmentPair> before = beads.pairs();
  const Yarn& last = fabric.yarns.back();
  const auto of_last = [&](const SegmentPair& pair) { return pair.b >= last.first_segment; };
  ASSERT_TRUE(std::any_of(before.begin(), before.end(), of_last));
  q.middleCols(last.first_point, last.points()).row(1).array() += 10e-3;
  beads.prepare(q);
  std::vector<SegmentPair> expected;
  std::copy_if(before.begin(), before.end(), std::back_inserter(expected),
               [&](const SegmentPair& pair) { return !of_last(pair) || pair.a >= last.first_segment; });
  EXPECT_EQ(beads.pairs(), expected);
}

TEST(BeadList, IsTheSameListWhereNothingCameOrWent) {
  const Fabric fabric = woven_yarns(4, 24, 7);
  Beads beads(fabric, sampling, screening, skin);
  Points q = fabric.points;
  beads.prepare(q);
  const long version = beads.version();
  const std::vector<SegmentPair> before = beads.pairs();
  const Yarn& yarn = fabric.yarns.front();
  for (int step = 0; step < 3; ++step) {  // its first end goes on outwards, away from all
    q.col(yarn.first_point).x() -= 3e-3;
    beads.prepare(q);
  }
  EXPECT_EQ(beads.pairs(), before);
  EXPECT_EQ(beads.version(), version);
  beads.forget_list();
  beads.prepare(q);
  EXPECT_GT(beads.version(), version);
}

}  // namespace
}  // namespace wale
