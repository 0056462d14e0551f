#include "sim/solvers/whereabouts.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/cells.hpp"
#include "tests/support/make_fabric.hpp"

namespace wale {
namespace {

std::string where(const Fabric& fabric, int column) {
  return whereabouts(World(fabric, {}, 0.0, at_rest(fabric)), column);
}

TEST(Whereabouts, AreASegmentOfAYarnWithoutStitches) {
  Fabric fabric = straight_rod(0.01, 4);
  add_yarn(fabric, straight_points({0, 0, 1e-3}, {0.01, 0, 1e-3}, 4), 0.0025);
  EXPECT_EQ(where(fabric, 0), "in segment 0 of yarn 0");
  EXPECT_EQ(where(fabric, 2), "in segment 1 of yarn 0");
  EXPECT_EQ(where(fabric, 7 + 2), "in segment 5 of yarn 1");
  EXPECT_EQ(where(fabric, 7 + 6), "in segment 7 of yarn 1");
}

TEST(Whereabouts, SayWhereAStitchIsWritten) {
  Fabric fabric = straight_rod(0.01, 4);
  fabric.segments[2].stitch = 5;
  EXPECT_EQ(where(fabric, 3), "in stitch 5 (segment 2 of yarn 0)");
  EXPECT_EQ(where(fabric, 1), "at an edge, beside stitch 5 (segment 0 of yarn 0)");
  fabric.source = "a.k";
  fabric.segments[2].line = 12;
  fabric.segments[2].column = 3;
  EXPECT_EQ(where(fabric, 3), "in stitch 5 of a.k:12:3 (segment 2 of yarn 0)");
  EXPECT_EQ(where(fabric, 4), "at an edge, beside stitch 5 of a.k:12:3 (segment 3 of yarn 0)");
}

TEST(Whereabouts, AreWorstWhereAVectorIsLongestOrNotFinite) {
  Points x(3, 3);
  x << 1, -3, 0, 0, 0, 2, 0, 1, 0;
  EXPECT_EQ(worst_column(x), 1);
  x(1, 2) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(worst_column(x), 2);
}

TEST(Whereabouts, MayBeThePeriods) {
  const Fabric cell = compile_repeat({"kk", "kk"}, 12).fabric;
  EXPECT_TRUE(where(cell, 0).starts_with("in stitch ")) << where(cell, 0);
  const int free = Ties(cell).free_columns();
  EXPECT_TRUE(where(cell, free - 3).starts_with("in stitch ")) << where(cell, free - 3);
  EXPECT_EQ(where(cell, free - 1), "on the periods");
}

}  // namespace
}  // namespace wale
