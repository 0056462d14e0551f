#include "sim/tile.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "sim/results/shown_fabric.hpp"
#include "sim/spline.hpp"
#include "tests/support/make_fabric.hpp"

namespace wale {
namespace {

constexpr double across = 5e-3, up = 2e-3;  // m

/// Two wavy yarns of 6 and 8 segments, one course above the other.
Fabric two_courses() {
  Fabric fabric;
  fabric.materials = {Material{}};
  fabric.cell = {{across, 0, 0}, {0, up, 0}};
  for (const int segments : {6, 8}) {
    Points points = straight_points({0, 1e-3 * fabric.segment_count() / 6, 0}, {across, 0, 0}, segments);
    for (int k = 0; k < segments; ++k) points.col(k) += Vec3::Random() * 1e-4;
    for (int k = 0; k < 3; ++k) points.col(segments + k) = points.col(k) + fabric.cell->course;
    add_yarn(fabric, points, across / segments);
    for (int k = 0; k < segments; ++k)
      fabric.segments[fabric.segments.size() - 1 - static_cast<std::size_t>(k)].stitch = k;
  }
  return fabric;
}

TEST(Tile, HasEveryRepeatWhereItsPeriodsPutIt) {
  const Fabric repeat = two_courses();
  const Fabric tiled = tile(repeat, points_and_periods(repeat), 3, 2);
  EXPECT_FALSE(tiled.cell);
  ASSERT_EQ(tiled.yarns.size(), 4U);
  EXPECT_EQ(tiled.segment_count(), 6 * repeat.segment_count());
  EXPECT_EQ(tiled.points.cols(), 2 * (3 * 6 + 3 + 3 * 8 + 3));
  for (int above = 0; above < 2; ++above)
    for (int to_right = 0; to_right < 3; ++to_right)
      for (int i = 0; i < repeat.segment_count(); ++i) {
        const int there = tile_segment(repeat, i, 3, to_right, above);
        const Vec3 by = to_right * repeat.cell->course + above * repeat.cell->wale;
        for (const double s : {0.0, 0.4, 1.0}) {
          const Vec3 at = combine(repeat.points, repeat.first_point(i), basis(s).value) + by;
          EXPECT_NEAR((combine(tiled.points, tiled.first_point(there), basis(s).value) - at).norm(), 0, 1e-15);
        }
        EXPECT_EQ(tiled.segment(there).stitch, repeat.segment(i).stitch);
        EXPECT_EQ(tiled.segment(there).length, repeat.segment(i).length);
        EXPECT_EQ(tiled.segment(there).yarn, 2 * above + repeat.segment(i).yarn);
      }
}

TEST(Tile, FollowsTheStateAndItsPeriods) {
  const Fabric repeat = two_courses();
  Points q = points_and_periods(repeat);
  q.rightCols<2>().col(0) = Vec3(2 * across, 0, 0);
  q.rightCols<2>().col(1) = Vec3(1e-3, up, 0);
  const Fabric tiled = tile(repeat, q, 1, 2);
  EXPECT_EQ(Vec3(tiled.points.col(tiled.yarns[2].first_point)), Vec3(repeat.points.col(0) + Vec3(1e-3, up, 0)));
}

TEST(ShownFabric, OfACellHasSixStitchesEachWay) {
  const Fabric repeat = two_courses();
  const Points q = points_and_periods(repeat);
  for (const auto& [wales, repeats] : {std::pair{1, 6}, {2, 3}, {4, 2}, {5, 2}, {6, 1}, {40, 1}}) {
    Gauge gauge;
    gauge.wales = wales;
    gauge.courses = 2;
    EXPECT_EQ(shown_fabric(repeat, gauge, q).segment_count(), 3 * repeats * repeat.segment_count()) << wales;
  }
}

TEST(ShownFabric, OfASwatchIsTheSwatchWhereItIsNow) {
  Fabric swatch = two_courses();
  swatch.cell.reset();
  const Points q = 2 * swatch.points;
  EXPECT_EQ(shown_fabric(swatch, {}, q).points, q);
}

TEST(Tile, IsOfPeriodicFabricsOnly) {
  Fabric fabric = two_courses();
  const Points q = points_and_periods(fabric);
  EXPECT_THROW(tile(fabric, fabric.points, 1, 1), std::invalid_argument);
  EXPECT_THROW(tile(fabric, q, 0, 1), std::invalid_argument);
  fabric.cell.reset();
  EXPECT_THROW(tile(fabric, q, 1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace wale
