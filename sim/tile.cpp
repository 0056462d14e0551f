#include "sim/tile.hpp"

#include <algorithm>
#include <stdexcept>

#include "sim/image.hpp"

namespace wale {
namespace {

/// One yarn of the repeat `above`, `across` times as long, after those that are there.
void add_yarn(const Fabric& periodic, const Points& q, const Yarn& yarn, int across, int above, Fabric& tiled) {
  const Vec3 course = q.rightCols<2>().col(0), wale = q.rightCols<2>().col(1);
  const bool curls = periodic.cell->may_curl();
  const int first_point = tiled.yarns.empty() ? 0 : tiled.yarns.back().first_point + tiled.yarns.back().points();
  const Yarn longer{first_point, tiled.segment_count(), across * yarn.segments};
  for (int k = 0; k < longer.points(); ++k) {
    // The last three points are the first three of a repeat that is not there any more.
    const int to_right = std::min(k / yarn.segments, across - 1), own = k - to_right * yarn.segments;
    const Vec3 point = q.col(yarn.first_point + own);
    tiled.points.col(first_point + k) = curls ? Image(*periodic.cell, q.rightCols<2>(), {to_right, above})(point)
                                              : point + to_right * course + above * wale;
  }
  for (int k = 0; k < longer.segments; ++k) {
    Segment segment = periodic.segment(yarn.first_segment + k % yarn.segments);
    segment.yarn = static_cast<int>(tiled.yarns.size());
    tiled.segments.push_back(segment);
  }
  tiled.yarns.push_back(longer);
}

}  // namespace

Points points_and_periods(const Fabric& periodic) {
  Points q(3, periodic.points.cols() + 2);
  q << periodic.points, periodic.cell->course, periodic.cell->wale;
  return q;
}

Fabric tile(const Fabric& periodic, const Points& q, int across, int up) {
  if (!periodic.cell || q.cols() != periodic.points.cols() + 2 || across < 1 || up < 1)
    throw std::invalid_argument("tile: not the points and periods of a periodic fabric");
  Fabric tiled;
  tiled.source = periodic.source;
  tiled.materials = periodic.materials;
  const auto yarns = static_cast<Eigen::Index>(periodic.yarns.size());
  tiled.points.resize(3, up * (across * Eigen::Index{periodic.segment_count()} + 3 * yarns));
  for (int above = 0; above < up; ++above)
    for (const Yarn& yarn : periodic.yarns) add_yarn(periodic, q, yarn, across, above, tiled);
  return tiled;
}

int tile_segment(const Fabric& periodic, int segment, int across, int to_right, int above) {
  const Yarn& yarn = periodic.yarns[static_cast<std::size_t>(periodic.segment(segment).yarn)];
  return across * (above * periodic.segment_count() + yarn.first_segment) + to_right * yarn.segments +
         (segment - yarn.first_segment);
}

}  // namespace wale
