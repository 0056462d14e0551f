#include "compiler/demand.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <optional>

#include "sim/spline.hpp"
#include "sim/tile.hpp"

namespace wale {
namespace {

struct Range {
  int first = -1, last = -1;
  int half() const { return (last - first) / 2; }
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

/// The loops before and after each on its yarn; -1 where there is none.
struct Neighbours {
  std::vector<int> before, after;
  explicit Neighbours(const StitchGraph& graph) : before(loops_before(graph)), after(before.size(), -1) {
    for (std::size_t i = 0; i < before.size(); ++i)
      if (before[i] >= 0) after[static_cast<std::size_t>(before[i])] = static_cast<int>(i);
  }
};

std::vector<Crossing> crossings_of(const StitchGraph& graph, const Arrangement& arrangement, const Fabric& fabric,
                                   const std::function<bool(const Loop&)>& wanted) {
  const auto ranges = ranges_by_stitch(fabric);
  const Neighbours along_yarn(graph);
  const auto head = [](const Range& of) { return (of.first + of.last + 1) / 2; };
  // A side reaches to the head beside it, or half a stitch into a float. Where the yarn turns to another course, or
  // goes up to one, it swings about freely, over or under the last loop, and tells nothing.
  const auto drawn = [&](int loop) -> const Hanging& { return arrangement.loops[static_cast<std::size_t>(loop)]; };
  std::vector<char> swings(graph.loops.size(), 0);
  for (const YarnStep& step : arrangement.steps)
    swings[static_cast<std::size_t>(step.to)] = step.turns || step.waits ? 1 : 0;
  const auto runs_on = [&](int to) { return !swings[static_cast<std::size_t>(to)]; };
  const auto start_of_side = [&](int loop) -> std::optional<int> {
    const int before = along_yarn.before[static_cast<std::size_t>(loop)];
    if (before < 0 || !runs_on(loop)) return {};
    const Range own = ranges.at(loop), beside = ranges.at(before);
    if (beside.last + 1 == own.first) return head(beside);
    return std::max(beside.last + 1, own.first - own.half());
  };
  const auto end_of_side = [&](int loop) -> std::optional<int> {
    const int after = along_yarn.after[static_cast<std::size_t>(loop)];
    if (after < 0 || !runs_on(after)) return {};
    const Range own = ranges.at(loop), beside = ranges.at(after);
    if (own.last + 1 == beside.first) return head(beside) - 1;
    return std::min(beside.first - 1, own.last + own.half());
  };
  std::vector<Crossing> crossings;
  for (int i = 0; i < static_cast<int>(graph.loops.size()); ++i) {
    const Loop& child = graph.loops[static_cast<std::size_t>(i)];
    if (!wanted(child)) continue;
    const std::optional<int> start = start_of_side(i), end = end_of_side(i);
    const int middle = head(ranges.at(i));
    for (const int parent : child.through) {
      const Range loop = ranges.at(parent);
      // Yarn pulled through the loop that it has just made begins where that loop ends.
      const bool chained = parent == along_yarn.before[static_cast<std::size_t>(i)];
      const int begin = chained ? std::max(start.value_or(0), loop.last + 1) : start.value_or(0);
      // The first side drawn goes up behind and over a knit loop's head; whether that turns left or right round it
      // depends on which way the loop below runs.
      const int sign = drawn(parent).heading * drawn(i).sign;
      if (start) crossings.push_back({begin, middle - 1, loop.first, loop.last, -sign});
      if (end) crossings.push_back({middle, *end, loop.first, loop.last, sign});
    }
  }
  return crossings;
}

}  // namespace

std::vector<Crossing> demanded_crossings(const StitchGraph& graph, const Arrangement& arrangement,
                                         const Fabric& fabric) {
  return crossings_of(graph, arrangement, fabric, [](const Loop&) { return true; });
}

std::vector<Crossing> lasting_crossings(const StitchGraph& graph, const Arrangement& arrangement,
                                        const Fabric& fabric) {
  return crossings_of(graph, arrangement, fabric, [](const Loop& loop) { return !loop.dropped; });
}

std::vector<Crossing> periodic_crossings(const StitchGraph& graph, const Arrangement& arrangement, const Fabric& tiled,
                                         const Repeat& repeat) {
  return crossings_of(graph, arrangement, tiled, [&repeat](const Loop& loop) { return repeat.holds(loop.cell); });
}

Fabric tile_of_loops(const Fabric& periodic, const StitchGraph& graph, const Repeat& repeat) {
  std::map<ChartCell, int> loops;
  for (int i = 0; i < static_cast<int>(graph.loops.size()); ++i)
    loops[graph.loops[static_cast<std::size_t>(i)].cell] = i;
  constexpr int count = repeats_for_crossings;
  Fabric tiled = tile(periodic, points_and_periods(periodic), count, count);
  for (int above = 0; above < count; ++above)
    for (int to_right = 0; to_right < count; ++to_right)
      for (int i = 0; i < periodic.segment_count(); ++i) {
        const int stitch = periodic.segment(i).stitch;
        if (stitch < 0) continue;
        const ChartCell& cell = graph.loops[static_cast<std::size_t>(stitch)].cell;
        const auto there = loops.find(
            {cell.course + (above - count / 2) * repeat.courses, cell.wale + (to_right - count / 2) * repeat.wales});
        tiled.segments[static_cast<std::size_t>(tile_segment(periodic, i, count, to_right, above))].stitch =
            there == loops.end() ? -1 : there->second;
      }
  return tiled;
}

Gauge gauge_of(const StitchGraph& graph, const Fabric& fabric) {
  const std::vector<int> courses = courses_of(graph);
  const auto ranges = ranges_by_stitch(fabric);
  Gauge gauge;
  gauge.wales = graph.widest;
  gauge.courses = courses.empty() ? 0 : 1 + *std::max_element(courses.begin(), courses.end());
  // Without loops on needles the fabric ends where it is bound off, in its last course.
  const bool open = !graph.on_needles.empty();
  for (int i = 0; i < static_cast<int>(graph.loops.size()); ++i) {
    const Loop& loop = graph.loops[static_cast<std::size_t>(i)];
    const Range range = ranges.at(i);
    const int quarter = (range.last - range.first + 1) / 4;
    const int course = courses[static_cast<std::size_t>(i)];
    if (course == 0 && loop.through.empty())
      for (const int k : {range.first, range.last}) gauge.wale_ends[0].push_back(k);
    if (open ? loop.held : course + 1 == gauge.courses)
      for (int k = range.first + quarter; k <= range.last - quarter; ++k) gauge.wale_ends[1].push_back(k);
  }
  return gauge;
}

Gauge gauge_of(const Chart& chart, const StitchGraph& graph, const Fabric& fabric) {
  Gauge gauge;
  gauge.wales = chart.wales();
  gauge.courses = chart.course_count();
  const auto stitch_near = [&](int i, int step) -> const ChartCell* {
    while (i >= 0 && i < fabric.segment_count() && fabric.segment(i).stitch < 0) i += step;
    const bool beyond = i < 0 || i >= fabric.segment_count();
    return beyond ? nullptr : &graph.loops[static_cast<std::size_t>(fabric.segment(i).stitch)].cell;
  };
  for (int i = 0; i < fabric.segment_count(); ++i) {
    const ChartCell *before = stitch_near(i, -1), *after = stitch_near(i, 1);
    if (!before || (after && after->course == 0 && before->course == 0)) gauge.wale_ends[0].push_back(i);
    if (!after || (before && before->course == gauge.courses - 1 && after->course == gauge.courses - 1))
      gauge.wale_ends[1].push_back(i);
    if (chart.form == Form::tube || !before || !after) continue;
    if (before->wale == 0 && after->wale == 0) gauge.course_ends[0].push_back(i);
    if (before->wale == gauge.wales - 1 && after->wale == gauge.wales - 1) gauge.course_ends[1].push_back(i);
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
