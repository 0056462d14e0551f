#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "compiler/passes.hpp"
#include "compiler/passes/crossing_loops.hpp"
#include "compiler/passes/springs.hpp"
#include "compiler/passes/surroundings.hpp"

namespace wale::passes {
namespace {

constexpr double sheet_distance = 2.2;  // of the two faces of a tube from its middle, in diameters
constexpr double sheet_pull = 0.15;     // of each bed to its own side, where one stitch pulls the next with 1
constexpr double back_to_back = 5;      // where loops of both beds share a place
constexpr double spacer_pull = 0.02;    // of yarn that goes to and fro between two sheets
constexpr double over_itself = 0.4;     // courses by which a cast-on that comes back lies above its way there
constexpr double most_over_itself = 0.6;
constexpr double split_distance = 2.4;  // diameters between two loops that were pulled through one to opposite sides
constexpr double least_rise = 0.2;      // courses from a loop's feet to its head
constexpr double faint = 1e-3;          // what places loops that nothing else does

/// Which heads hang where, from the graph alone.
class Hangings {
 public:
  explicit Hangings(const StitchGraph& graph) : graph_(graph) { of_.loops.resize(graph.loops.size()); }

  Arrangement hang() {
    for (int i = 0; i < static_cast<int>(graph_.loops.size()); ++i) put_feet(i);
    for (const HeldLoops& held : graph_.on_needles) put_heads(held.loops);
    for (int i = 0; i < static_cast<int>(graph_.loops.size()); ++i)
      if (at(i).head < 0) put_heads({i});
    return std::move(of_);
  }

 private:
  const Loop& loop(int i) const { return graph_.loops[static_cast<std::size_t>(i)]; }
  Hanging& at(int i) { return of_.loops[static_cast<std::size_t>(i)]; }

  int new_anchor() {
    of_.anchors.emplace_back();
    return static_cast<int>(of_.anchors.size()) - 1;
  }

  /// Loops that one instruction makes of several yarns lie together.
  void put_feet(int i) {
    const bool plated = i > 0 && loop(i).instruction >= 0 && loop(i - 1).instruction == loop(i).instruction;
    Hanging& own = at(i);
    own.sign = on_back(loop(i).needle) ? -1 : 1;
    own.heading = loop(i).direction == Direction::decreasing ? -1 : 1;
    own.feet = plated ? at(i - 1).feet : new_anchor();
    Anchor& anchor = of_.anchors[static_cast<std::size_t>(own.feet)];
    anchor.feet.push_back(i);
    if (plated) return;
    anchor.heads = loop(i).through;
    for (const int parent : loop(i).through) {
      at(parent).via = at(parent).head;
      at(parent).head = own.feet;
    }
  }

  void put_heads(const std::vector<int>& loops) {
    std::vector<int> free;
    for (const int i : loops)
      if (at(i).head < 0) free.push_back(i);
    if (free.empty()) return;
    const int anchor = new_anchor();
    for (const int i : free) at(i).head = anchor;
    of_.anchors[static_cast<std::size_t>(anchor)].heads = std::move(free);
  }

  const StitchGraph& graph_;
  Arrangement of_;
};

double needles_between(const StitchGraph& graph, const YarnStep& step) {
  const Loop &from = graph.loops[static_cast<std::size_t>(step.from)],
             &to = graph.loops[static_cast<std::size_t>(step.to)];
  return std::abs(position(to.needle, to.racking) - position(from.needle, from.racking));
}

/// At half gauge every other needle is empty; in a full rib both beds share the places.
double columns_per_needle(const StitchGraph& graph, const std::vector<YarnStep>& steps) {
  std::vector<double> ratios;
  for (const YarnStep& step : steps) {
    const double needles = needles_between(graph, step);
    if (!step.turns && needles != 0) ratios.push_back(step.apart / needles);
  }
  if (ratios.empty()) return 1;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

/// Needles that are empty yet, as in a cast-on that takes every fifth, will have their columns too.
void leave_room(const StitchGraph& graph, std::vector<YarnStep>& steps) {
  const double per_needle = columns_per_needle(graph, steps);
  for (YarnStep& step : steps)
    step.apart = std::max(step.apart, static_cast<int>(std::lround(per_needle * needles_between(graph, step))));
}

/// Loops through which the same yarn is pulled again before it turns, as in a bind-off.
std::vector<bool> chained_loops(const StitchGraph& graph) {
  constexpr std::size_t soon = 3;  // loops, since a bind-off may tuck on the other bed on its way
  std::vector<bool> chained(graph.loops.size(), false);
  for (const YarnPath& yarn : graph.yarns)
    for (std::size_t k = 1; k < yarn.loops.size(); ++k) {
      const Loop& child = graph.loops[static_cast<std::size_t>(yarn.loops[k])];
      for (std::size_t back = 1; back <= std::min(soon, k); ++back) {
        const int before = yarn.loops[k - back];
        if (graph.loops[static_cast<std::size_t>(before)].direction != child.direction) break;
        if (std::find(child.through.begin(), child.through.end(), before) != child.through.end())
          chained[static_cast<std::size_t>(before)] = true;
      }
    }
  return chained;
}

/// How high above the first course each loop's feet lie, in courses.
class Levels {
 public:
  Levels(const StitchGraph& graph, const Arrangement& arrangement, const std::vector<bool>& chained)
      : graph_(graph), arrangement_(arrangement), chained_(chained), of_(graph.loops.size(), 0) {}

  /// As courses_of(), but a chain along an edge stays in one course, a tuck lies one above the loops that it hangs
  /// with, and a cast-on that goes back over itself lies a little higher each time.
  std::vector<double> find() {
    const std::vector<int> before = loops_before(graph_);
    for (int i = 0; i < static_cast<int>(of_.size()); ++i)
      level(i) = loop(i).through.empty() ? beside(i, before[static_cast<std::size_t>(i)]) : above(i);
    return of_;
  }

 private:
  const Loop& loop(int i) const { return graph_.loops[static_cast<std::size_t>(i)]; }
  double& level(int i) { return of_[static_cast<std::size_t>(i)]; }

  double above(int i) {
    double highest = 0;
    for (const int parent : loop(i).through)
      highest = std::max(highest, std::floor(level(parent)) + (chained_[static_cast<std::size_t>(parent)] ? 0 : 1));
    return highest;
  }

  double beside(int i, int before) {
    const double along = before >= 0 ? std::floor(level(before)) : 0;
    const Hanging& own = arrangement_.loops[static_cast<std::size_t>(i)];
    double highest = along;
    for (const int with : arrangement_.anchors[static_cast<std::size_t>(own.head)].heads)
      if (with < i && !loop(with).through.empty()) highest = std::max(highest, std::floor(level(with)) + 1);
    // A yarn that tucks on its way there and back again.
    auto& passes = passes_[{loop(i).carrier, own.sign, static_cast<int>(along)}];
    passes.insert(loop(i).course);
    return highest + std::min(most_over_itself, over_itself * static_cast<double>(passes.size() - 1));
  }

  const StitchGraph& graph_;
  const Arrangement& arrangement_;
  const std::vector<bool>& chained_;
  std::vector<double> of_;
  std::map<std::array<int, 3>, std::set<int>> passes_;  // by carrier, bed and course
};

/// Finds where everything lies: stitches pull their neighbours to the distances of a loose fabric.
class Arranging {
 public:
  Arranging(const StitchGraph& graph, const LoopSize& size, double diameter, const std::vector<int>& across,
            Arrangement& of)
      : graph_(graph),
        size_(size),
        diameter_(diameter),
        across_(across),
        of_(of),
        chained_(chained_loops(graph)),
        levels_(Levels(graph, of, chained_).find()),
        columns_per_needle_(columns_per_needle(graph, of.steps)) {}

  void solve() {
    const Eigen::VectorXd x = across(), y = upwards(), z = sheets();
    for (std::size_t i = 0; i < of_.anchors.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      of_.anchors[i].at = {x(k), y(k), z(k)};
    }
    lift();
    turn_up();
  }

 private:
  const Loop& loop(int i) const { return graph_.loops[static_cast<std::size_t>(i)]; }
  const Hanging& at(int i) const { return of_.loops[static_cast<std::size_t>(i)]; }
  double level(int i) const { return levels_[static_cast<std::size_t>(i)]; }

  /// By how many needles transfers moved a loop.
  static double shift(const Loop& of) {
    return position(of.last_needle, of.last_racking) - position(of.needle, of.racking);
  }

  /// In a bind-off a loop lies along the edge: the next loop of its own yarn is pulled through it.
  double sideways(int i) const { return chained_[static_cast<std::size_t>(i)] ? at(i).heading * size_.wale() : 0; }

  int first_head(int i) const { return at(i).via >= 0 ? at(i).via : at(i).head; }
  int first_foot(int anchor) const { return of_.anchors[static_cast<std::size_t>(anchor)].feet.front(); }
  int sign_of(int anchor) const { return at(first_foot(anchor)).sign; }

  /// Courses from the first loop pulled through a split one to the second.
  double split_rise(int i) const {
    return std::max(over_itself, level(first_foot(at(i).head)) - level(first_foot(at(i).via)));
  }

  /// Courses from a loop's feet to its head: a loop that waits on its needle is drawn long.
  double rise(int i) const {
    if (chained_[static_cast<std::size_t>(i)]) return 0;
    const Anchor& head = of_.anchors[static_cast<std::size_t>(first_head(i))];
    return head.feet.empty() ? 1 : std::max(least_rise, level(head.feet.front()) - level(i));
  }

  Eigen::VectorXd upwards() const {
    Springs springs(of_.anchors.size());
    for (int i = 0; i < static_cast<int>(of_.loops.size()); ++i) {
      const double n = rise(i);
      springs.between(at(i).feet, first_head(i), n * size_.pitch, 1 / std::max(1.0, n * n));
      if (at(i).via >= 0) springs.between(at(i).via, at(i).head, split_rise(i) * size_.pitch, 1);
      springs.towards(at(i).feet, level(i) * size_.pitch, faint);
    }
    for (const YarnStep& step : of_.steps)
      if (!step.turns) springs.between(at(step.from).feet, at(step.to).feet, 0, step.apart > 3 ? 0.1 : 1);
    return springs.rest();
  }

  Eigen::VectorXd across() const {
    Springs springs(of_.anchors.size());
    const double per_needle = size_.wale() * columns_per_needle_;
    for (int i = 0; i < static_cast<int>(of_.loops.size()); ++i) {
      if (at(i).via >= 0) springs.between(at(i).via, at(i).head, 0, 1);
      springs.between(at(i).feet, first_head(i), at(i).passes ? per_needle * shift(loop(i)) : sideways(i), 1);
      springs.towards(at(i).feet, per_needle * position(loop(i).needle, loop(i).racking), faint);
    }
    for (const YarnStep& step : of_.steps)
      if (!step.turns)
        springs.between(at(step.from).feet, at(step.to).feet, at(step.to).heading * step.apart * size_.wale(),
                        1.0 / (step.apart * step.apart));
    return springs.rest();
  }

  /// Where both beds knit a sheet each, as in a tube, the sheets lie apart; where stitches of both alternate they draw
  /// each other to the middle.
  Eigen::VectorXd sheets() const {
    Springs springs(of_.anchors.size());
    for (int i = 0; i < static_cast<int>(of_.loops.size()); ++i) {
      springs.between(at(i).feet, first_head(i), 0, 1);
      // The sheet that was knitted first lies on the side of its bed.
      if (at(i).via >= 0) springs.between(at(i).via, at(i).head, -sign_of(at(i).via) * split_distance * diameter_, 1);
      const double pull = across_[static_cast<std::size_t>(i)] >= 0 ? back_to_back : sheet_pull;
      springs.towards(at(i).feet, at(i).sign * sheet_distance * diameter_, pull);
    }
    for (const YarnStep& step : of_.steps)
      if (!step.turns) springs.between(at(step.from).feet, at(step.to).feet, 0, spans_the_gap(step) ? spacer_pull : 1);
    return springs.rest();
  }

  /// Yarn tucked on one bed and then on the other holds two sheets together at a distance.
  bool spans_the_gap(const YarnStep& step) const {
    return at(step.from).sign != at(step.to).sign && (loop(step.from).through.empty() || loop(step.to).through.empty());
  }

  /// The yarn of a later pass lies above what an earlier one laid between the beds at the same height.
  void lift() {
    std::vector<Vec3*> above;
    for (int i = 0; i < static_cast<int>(of_.loops.size()); ++i) {
      const int other = across_[static_cast<std::size_t>(i)];
      if (other < 0 || loop(other).course == loop(i).course) continue;
      Vec3& feet = of_.anchors[static_cast<std::size_t>(at(i).feet)].at;
      const Vec3& facing = of_.anchors[static_cast<std::size_t>(at(other).feet)].at;
      if (std::abs(feet.y() - facing.y()) < over_itself / 2 * size_.pitch) above.push_back(&feet);
    }
    for (Vec3* feet : above) feet->y() += over_itself * size_.pitch;
  }

  /// Loops stand upright on their feet as far as they lean themselves.
  void turn_up() {
    std::vector<Vec3> lean(of_.anchors.size(), Vec3(0, size_.pitch, 0));
    for (const Hanging& loop : of_.loops) {
      if (loop.passes) continue;
      Vec3 rise =
          of_.anchors[static_cast<std::size_t>(loop.head)].at - of_.anchors[static_cast<std::size_t>(loop.feet)].at;
      rise.z() = 0;
      lean[static_cast<std::size_t>(loop.feet)] += rise;
      lean[static_cast<std::size_t>(loop.head)] += rise;
    }
    for (std::size_t i = 0; i < lean.size(); ++i)
      if (lean[i].norm() > 1e-3 * size_.pitch) of_.anchors[i].up = lean[i].normalized();
  }

  const StitchGraph& graph_;
  const LoopSize& size_;
  double diameter_;
  const std::vector<int>& across_;
  Arrangement& of_;
  std::vector<bool> chained_;
  std::vector<double> levels_;
  double columns_per_needle_;
};

}  // namespace

Arrangement arrange(const StitchGraph& graph, const LoopSize& size, double diameter) {
  Arrangement arrangement = Hangings(graph).hang();
  const Surroundings around = surroundings(graph);
  arrangement.steps = around.steps;
  leave_room(graph, arrangement.steps);
  mark_crossing_loops(graph, arrangement);
  Arranging(graph, size, diameter, around.across, arrangement).solve();
  return arrangement;
}

}  // namespace wale::passes
