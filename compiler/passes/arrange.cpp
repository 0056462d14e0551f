#include <algorithm>
#include <cmath>

#include "compiler/passes.hpp"
#include "compiler/passes/crossing_loops.hpp"
#include "compiler/passes/hang.hpp"
#include "compiler/passes/levels.hpp"
#include "compiler/passes/springs.hpp"
#include "compiler/passes/surroundings.hpp"

namespace wale::passes {
namespace {

constexpr double sheet_distance = 2.2;  // of the two faces of a tube from its middle, in diameters
constexpr double sheet_pull = 0.15;     // of each bed to its own side, where one stitch pulls the next with 1
constexpr double back_to_back = 5;      // where loops of both beds share a place
constexpr double spacer_pull = 0.02;    // of yarn that goes to and fro between two sheets
constexpr double split_distance = 2.4;  // diameters between two loops that were pulled through one to opposite sides
constexpr double least_rise = 0.2;      // courses from a loop's feet to its head
constexpr double faint = 1e-3;          // what places loops that nothing else does

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
        levels_(levels_of(graph, of, chained_)),
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
  Arrangement arrangement = hang(graph);
  const Surroundings around = surroundings(graph);
  arrangement.steps = around.steps;
  leave_room(graph, arrangement.steps);
  mark_crossing_loops(graph, arrangement);
  Arranging(graph, size, diameter, around.across, arrangement).solve();
  return arrangement;
}

}  // namespace wale::passes
