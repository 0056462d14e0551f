#include "sim/solvers/whereabouts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wale {
namespace {

/// A segment beside a control point; -1 if the column is a period.
int segment_beside(const World& world, int column) {
  for (const Yarn& yarn : world.fabric().yarns)
    for (int k = 0; k < yarn.points(); ++k)
      if (world.ties().free_column(yarn.first_point + k) == column)
        // The second of its four control points lies nearest to where a segment begins.
        return yarn.first_segment + std::clamp(k - 1, 0, yarn.segments - 1);
  return -1;
}

/// The segment of a stitch that is nearest along the yarn; -1 if that has none.
int nearest_in_stitch(const Fabric& fabric, int segment) {
  const Yarn& yarn = fabric.yarns[static_cast<std::size_t>(fabric.segment(segment).yarn)];
  for (int away = 0; away < yarn.segments; ++away)
    for (const int at : {segment - away, segment + away})
      if (at >= yarn.first_segment && at < yarn.first_segment + yarn.segments && fabric.segment(at).stitch >= 0)
        return at;
  return -1;
}

std::string stitch_of(const Fabric& fabric, const Segment& segment) {
  if (segment.line == 0) return fmt::format("stitch {}", segment.stitch);
  return fmt::format("stitch {} of {}:{}:{}", segment.stitch, fabric.source, segment.line, segment.column);
}

}  // namespace

std::string whereabouts(const World& world, int column) {
  const Fabric& fabric = world.fabric();
  const int at = segment_beside(world, column);
  if (at < 0) return "on the periods";
  const std::string segment = fmt::format("segment {} of yarn {}", at, fabric.segment(at).yarn);
  const int near = nearest_in_stitch(fabric, at);
  if (near < 0) return "in " + segment;
  const char* in = near == at ? "in" : "at an edge, beside";
  return fmt::format("{} {} ({})", in, stitch_of(fabric, fabric.segment(near)), segment);
}

int worst_column(const Points& x) {
  int worst = 0;
  double longest = -1;
  for (int column = 0; column < x.cols(); ++column) {
    const double length = x.col(column).squaredNorm();
    if (!std::isfinite(length)) return column;
    if (length > longest) {
      longest = length;
      worst = column;
    }
  }
  return worst;
}

}  // namespace wale
