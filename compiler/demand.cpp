#include "compiler/demand.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "sim/spline.hpp"

namespace wale {
namespace {

struct Range {
  int first = -1, last = -1;
};

std::map<int, Range> ranges_by_stitch(const Fabric& fabric) {
  std::map<int, Range> ranges;
  for (int i = 0; i < fabric.segment_count(); ++i) {
    Range& range = ranges[fabric.segment(i).stitch];
    if (range.first < 0) range.first = i;
    range.last = i;
  }
  return ranges;
}

std::map<int, const PlacedLoop*> by_stitch(const Layout& layout) {
  std::map<int, const PlacedLoop*> placed;
  for (const auto& row : layout.rows)
    for (const PlacedLoop& loop : row) placed[loop.loop] = &loop;
  return placed;
}

}  // namespace

std::vector<Crossing> demanded_crossings(const Layout& layout, const Fabric& fabric) {
  const auto ranges = ranges_by_stitch(fabric);
  const auto head = [](const Range& of) { return (of.first + of.last + 1) / 2; };
  // A side reaches to the head beside it. At a selvedge there is none: the yarn that joins two courses swings about
  // freely, over or under the last loop, and tells nothing.
  const auto neighbour = [&](int beyond) -> const Range* {
    if (beyond < 0 || beyond >= fabric.segment_count() || fabric.segment(beyond).stitch < 0) return nullptr;
    return &ranges.at(fabric.segment(beyond).stitch);
  };
  std::vector<Crossing> crossings;
  for (std::size_t course = 1; course < layout.rows.size(); ++course)
    for (std::size_t wale = 0; wale < layout.rows[course].size(); ++wale) {
      const PlacedLoop& child = layout.rows[course][wale];
      const Range own = ranges.at(child.loop), loop = ranges.at(layout.rows[course - 1][wale].loop);
      // The first side drawn goes up behind and over a knit loop's head; whether that turns left or right round it
      // depends on which way the loop below runs.
      const int running = layout.from_left[course - 1] ? 1 : -1;
      if (const Range* before = neighbour(own.first - 1))
        crossings.push_back({head(*before), head(own) - 1, loop.first, loop.last, -running * child.sign});
      if (const Range* after = neighbour(own.last + 1))
        crossings.push_back({head(own), head(*after) - 1, loop.first, loop.last, running * child.sign});
    }
  return crossings;
}

Gauge gauge_of(const Layout& layout, const Fabric& fabric) {
  const auto placed = by_stitch(layout);
  Gauge gauge;
  gauge.wales = layout.wales;
  gauge.courses = layout.courses;
  const auto stitch_near = [&](int i, int step) {
    while (i >= 0 && i < fabric.segment_count() && fabric.segment(i).stitch < 0) i += step;
    const bool beyond = i < 0 || i >= fabric.segment_count();
    return beyond ? nullptr : placed.at(fabric.segment(i).stitch);
  };
  for (int i = 0; i < fabric.segment_count(); ++i) {
    const PlacedLoop *before = stitch_near(i, -1), *after = stitch_near(i, 1);
    if (!before || (after && after->course == 0 && before->course == 0)) gauge.wale_ends[0].push_back(i);
    if (!after || (before && before->course == layout.courses - 1 && after->course == layout.courses - 1))
      gauge.wale_ends[1].push_back(i);
    if (layout.form == Form::tube || !before || !after) continue;
    if (before->wale == 0 && after->wale == 0) gauge.course_ends[0].push_back(i);
    if (before->wale == layout.wales - 1 && after->wale == layout.wales - 1) gauge.course_ends[1].push_back(i);
  }
  return gauge;
}

Knots secured_ends(const Fabric& fabric) {
  Knots tied;
  for (const Yarn& yarn : fabric.yarns)
    for (const bool at_end : {false, true}) {
      const int end = yarn.first_segment + (at_end ? yarn.segments - 1 : 0);
      const double s = at_end ? 1 : 0;
      const Vec3 tip = combine(fabric.points, fabric.first_point(end), basis(s).value);
      int nearest = -1;
      double least = std::numeric_limits<double>::infinity();
      for (int i = 0; i < fabric.segment_count(); ++i) {
        if (fabric.segment(i).stitch < 0) continue;
        const double distance = (combine(fabric.points, fabric.first_point(i), basis(0.5).value) - tip).norm();
        if (distance < least) least = distance, nearest = i;
      }
      if (nearest >= 0) tied.knots.push_back({end, nearest, s, 0.5, fabric.material_of(end).diameter});
    }
  return tied;
}

}  // namespace wale
