#include "sim/results/topology.hpp"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "compiler/compile.hpp"
#include "tests/support/grid.hpp"
#include "tests/support/projected_crossings.hpp"
#include "tests/support/structures.hpp"

namespace wale {
namespace {

CompiledChart compiled(const Chart& chart, int segments) {
  Diagnostics say;
  auto made = compile_chart(chart, segments, say);
  if (!made) throw std::runtime_error("the chart was refused");
  return std::move(*made);
}

/// What one place of a loop meets: a loop of the chart, or the cast-on, a join or the bind-off (loop -1).
struct Meeting {
  double here = 0, there = 0;  ///< along the yarn, segments
  int partner = -1;
  int above = 0;  ///< +1: this loop is nearer to the viewer
};

/// The drawing, read by loops.
class Reading {
 public:
  Reading(const CompiledChart& made, const Points& q) : made_(made) {
    const Drawn drawn = drawn_from_the_face(made.fabric, q, made.chart.form == Form::tube);
    find_feet(drawn);
    for (const SeenCrossing& seen : projected_crossings(drawn)) {
      const int a = stitch_at(seen.first), b = stitch_at(seen.second);
      if (a >= 0) meetings_[a].push_back({seen.first, seen.second, b, seen.above});
      if (b >= 0) meetings_[b].push_back({seen.second, seen.first, a, -seen.above});
      if (a < 0 && b < 0) ++among_edges_;
    }
    for (auto& [loop, meetings] : meetings_)
      std::sort(meetings.begin(), meetings.end(), [](const Meeting& x, const Meeting& y) { return x.here < y.here; });
  }

  const std::vector<Meeting>& of(int loop) { return meetings_[loop]; }
  std::vector<Meeting> between(int loop, int partner) {
    std::vector<Meeting> some;
    for (const Meeting& meeting : meetings_[loop])
      if (meeting.partner == partner) some.push_back(meeting);
    return some;
  }
  int among_edges() const { return among_edges_; }

 private:
  /// A segment that holds a foot belongs to one stitch only; the foot itself is where the yarn lies lowest.
  void find_feet(const Drawn& drawn) {
    const Fabric& fabric = made_.fabric;
    starts_[0] = fabric.segment(0).stitch;
    for (int i = 1; i < fabric.segment_count(); ++i) {
      if (fabric.segment(i).stitch == fabric.segment(i - 1).stitch) continue;
      const int near = drawn.per_segment;
      Eigen::Index lowest = 0;
      drawn.points.row(1).segment((i - 1) * near, 2 * near).minCoeff(&lowest);
      starts_[i - 1 + static_cast<double>(lowest) / near] = fabric.segment(i).stitch;
    }
  }

  int stitch_at(double along) const { return std::prev(starts_.upper_bound(along))->second; }

  const CompiledChart& made_;
  std::map<int, std::vector<Meeting>> meetings_;
  std::map<double, int> starts_;  // where along the yarn each stitch or edge begins
  int among_edges_ = 0;
};

/// Along the child: sinker, leg, leg, sinker. The leg passes the parent's head, the sinker the parent's upper leg on
/// the same side; both with the sign of the child: leg over head and upper leg over sinker for +1.
void expect_pulled_through(Reading& reading, const GridLoop& child, const GridLoop& parent, bool same_way) {
  const std::vector<Meeting> met = reading.between(child.loop, parent.loop);
  ASSERT_EQ(met.size(), 4U);
  const int s = child.sign;
  EXPECT_EQ((std::vector{met[0].above, met[1].above, met[2].above, met[3].above}), (std::vector{-s, s, s, -s}));
  for (std::size_t k = 1; k < 4; ++k) EXPECT_EQ(met[k].there > met[k - 1].there, same_way);
}

/// From foot to foot a loop meets the one below, the one above four times, and the one below again.
void expect_in_order(Reading& reading, const GridLoop& loop, int below, int above) {
  std::vector<int> met, demanded;
  for (const Meeting& meeting : reading.of(loop.loop))
    if (meeting.partner >= 0) met.push_back(meeting.partner);
  if (below >= 0) demanded.insert(demanded.end(), 2, below);
  if (above >= 0) demanded.insert(demanded.end(), 4, above);
  if (below >= 0) demanded.insert(demanded.end(), 2, below);
  EXPECT_EQ(met, demanded);
}

/// Each sinker between two loops of the first course goes once over and once under the cast-on.
void expect_cast_on(Reading& reading, const LoopGrid& grid) {
  std::vector<Meeting> met;
  const int wales = grid.wales;
  for (int k = 0; k < wales; ++k) {
    const auto wale = static_cast<std::size_t>(grid.from_left.front() ? k : wales - 1 - k);
    const std::vector<Meeting> here = reading.between(grid.rows.front()[wale].loop, -1);
    EXPECT_EQ(here.size(), k == 0 || k == wales - 1 ? 1U : 2U) << "wale " << wale;
    met.insert(met.end(), here.begin(), here.end());
  }
  for (std::size_t k = 1; k < met.size(); k += 2) EXPECT_EQ(met[k - 1].above, -met[k].above);
}

/// The head of each loop of the last course goes once over and once under the bind-off.
void expect_bind_off(Reading& reading, const LoopGrid& grid) {
  for (const GridLoop& loop : grid.rows.back()) {
    const std::vector<Meeting> met = reading.between(loop.loop, -1);
    ASSERT_EQ(met.size(), 2U) << "wale " << loop.wale;
    EXPECT_EQ(met[0].above, -met[1].above) << "wale " << loop.wale;
  }
}

void expect_demanded_crossings(const CompiledChart& made) {
  Reading reading(made, made.fabric.points);
  const LoopGrid grid = grid_of(made.chart, made.graph, made.arrangement);
  const auto& rows = grid.rows;
  for (std::size_t course = 0; course < rows.size(); ++course)
    for (std::size_t wale = 0; wale < rows[course].size(); ++wale) {
      SCOPED_TRACE("course " + std::to_string(course) + ", wale " + std::to_string(wale));
      const GridLoop& loop = rows[course][wale];
      const GridLoop* below = course > 0 ? &rows[course - 1][wale] : nullptr;
      const GridLoop* above = course + 1 < rows.size() ? &rows[course + 1][wale] : nullptr;
      expect_in_order(reading, loop, below ? below->loop : -1, above ? above->loop : -1);
      if (below) expect_pulled_through(reading, loop, *below, grid.from_left[course] == grid.from_left[course - 1]);
      EXPECT_TRUE(!below || !above || reading.between(loop.loop, -1).empty());
    }
  expect_cast_on(reading, grid);
  expect_bind_off(reading, grid);
  EXPECT_EQ(reading.among_edges(), 0);
}

TEST(CompiledTopology, IsExactlyWhatTheStitchGraphDemands) {
  for (const auto& [name, chart] : all_structures()) {
    SCOPED_TRACE(name);
    expect_demanded_crossings(compiled(chart, 12));
  }
}

TEST(CompiledTopology, HoldsAtFinerSegments) {
  for (const Form form : {Form::flat, Form::tube})
    for (const auto& [name, chart] : random_mixtures(6, form)) {
      SCOPED_TRACE(name);
      expect_demanded_crossings(compiled(chart, 25));
    }
}

TEST(CheckCrossings, FindsAllThatACompiledFabricDemandsAndNoneInItsMirrorImage) {
  for (const auto& [name, chart] : all_structures()) {
    SCOPED_TRACE(name);
    const CompiledChart made = compiled(chart, 12);
    const Topology found = check_crossings(made.fabric, made.crossings, made.fabric.points);
    // A yarn's end and a selvedge have no loop beyond.
    const long sides = made.chart.form == Form::tube ? 2 * made.chart.wales() * (made.chart.course_count() - 1) - 1
                                                     : 2 * (made.chart.wales() - 1) * (made.chart.course_count() - 1);
    EXPECT_EQ(found.expected, sides);
    EXPECT_TRUE(found.intact()) << found.found << " of " << found.expected;
    Points mirrored = made.fabric.points;
    mirrored.row(2) *= -1;
    EXPECT_EQ(check_crossings(made.fabric, made.crossings, mirrored).found, 0);
  }
}

/// Pushes one leg of the loop at this place through the head of the loop below.
Points with_a_leg_pushed_through(const CompiledChart& made, std::size_t course, std::size_t wale, std::size_t leg) {
  const LoopGrid grid = grid_of(made.chart, made.graph, made.arrangement);
  const GridLoop &child = grid.rows[course][wale], &parent = grid.rows[course - 1][wale];
  Reading reading(made, made.fabric.points);
  const double at = reading.between(child.loop, parent.loop)[leg].here;
  Points pushed = made.fabric.points;
  for (int k = -1; k <= 1; ++k)  // control point s of the yarn's one spline acts most at parameter s - 1
    pushed(2, 1 + static_cast<int>(std::lround(at)) + k) -= 3.5 * child.sign * made.fabric.materials.front().diameter;
  return pushed;
}

TEST(CheckCrossings, NoticesASingleLegThatSlippedThrough) {
  for (const auto& [name, chart] : basic_structures(5, 4, Form::flat)) {
    SCOPED_TRACE(name);
    const CompiledChart made = compiled(chart, 24);
    for (const std::size_t leg : {1U, 2U}) {
      const Points pushed = with_a_leg_pushed_through(made, 2, 3, leg);
      const Topology found = check_crossings(made.fabric, made.crossings, pushed);
      EXPECT_EQ(found.found, found.expected - 1);
    }
  }
}

}  // namespace
}  // namespace wale
