#include "sim/effects/segment_blocks.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "tests/support/make_fabric.hpp"

namespace wale {
namespace {

Fabric yarns_of(const std::vector<int>& lengths) {
  Fabric fabric;
  for (const int segments : lengths) add_yarn(fabric, straight_points(Vec3::Zero(), Vec3(segments, 0, 0), segments), 1);
  return fabric;
}

std::vector<int> from_to(int first, int last) {
  std::vector<int> all(static_cast<std::size_t>(last - first));
  std::iota(all.begin(), all.end(), first);
  return all;
}

TEST(SegmentBlocks, HoldEachSegmentOnceInPiecesOfOneYarn) {
  const Fabric fabric = yarns_of({1, 2, 3, 64, 65, 200});
  for (const bool ends_alone : {false, true}) {
    const SegmentBlocks blocks(fabric, from_to(0, fabric.segment_count()), ends_alone);
    std::set<int> seen;
    for (const SegmentBlock& block : blocks.all()) {
      ASSERT_LE(block.count, static_cast<std::size_t>(block_length));
      for (std::size_t i = block.begin; i < block.end(); ++i) {
        EXPECT_TRUE(seen.insert(blocks.segments()[i]).second);
        EXPECT_EQ(blocks.segments()[i], blocks.segments()[block.begin] + static_cast<int>(i - block.begin));
        EXPECT_EQ(fabric.segment(blocks.segments()[i]).yarn, fabric.segment(blocks.segments()[block.begin]).yarn);
      }
    }
    EXPECT_EQ(static_cast<int>(seen.size()), fabric.segment_count());
  }
}

TEST(SegmentBlocks, ShareNoControlPointWithinAColour) {
  const Fabric fabric = yarns_of({1, 2, 3, 64, 65, 200});
  for (const bool ends_alone : {false, true}) {
    const SegmentBlocks blocks(fabric, from_to(0, fabric.segment_count()), ends_alone);
    std::size_t coloured = 0;
    for (const auto& [first, last] : blocks.colours()) {
      std::set<int> points;
      for (std::size_t b = first; b < last; ++b, ++coloured)
        for (int k = 0; k < static_cast<int>(blocks.all()[b].count) + 3; ++k)
          EXPECT_TRUE(points.insert(fabric.first_point(blocks.segments()[blocks.all()[b].begin]) + k).second);
    }
    EXPECT_EQ(coloured, blocks.all().size());
  }
}

TEST(SegmentBlocks, SetTheEndsOfYarnsApartWhenAsked) {
  const Fabric fabric = yarns_of({1, 2, 70});
  const SegmentBlocks blocks(fabric, from_to(0, fabric.segment_count()), true);
  std::set<int> alone;
  for (const SegmentBlock& block : blocks.all())
    if (block.at_end) {
      EXPECT_EQ(block.count, 1U);
      alone.insert(blocks.segments()[block.begin]);
    }
  EXPECT_EQ(alone, (std::set<int>{0, 1, 2, 3, 72}));
}

}  // namespace
}  // namespace wale
