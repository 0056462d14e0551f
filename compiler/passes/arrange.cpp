#include <algorithm>
#include <cmath>

#include "compiler/passes.hpp"
#include "compiler/passes/crossing_loops.hpp"
#include "compiler/passes/hang.hpp"
#include "compiler/passes/levels.hpp"
#include "compiler/passes/springs.hpp"
#include "compiler/passes/surroundings.hpp"
#include "compiler/passes/tube.hpp"
#include "compiler/passes/uprights.hpp"

namespace wale::passes {
namespace {

constexpr double sheet_distance = 2.2;  // of the two faces of a tube from its middle, in diameters
constexpr double sheet_pull = 0.15;     // of each bed to its own side, where one stitch pulls the next with 1
constexpr double back_to_back = 5;      // where loops of both beds share a place
constexpr double spacer_pull = 0.02;    // of yarn that goes to and fro between two sheets
constexpr double split_distance = 2.4;  // diameters between two loops that were pulled through one to opposite sides
constexpr double steepest_lean = 2;     // how far a loop may lean over its height
constexpr double least_rise = 0.2;      // courses from a loop's feet to its head
constexpr double row_pull = 0.5;        // of loops of one row to one height, where a loop keeps its head up with 1
constexpr double turn_pull = 0.05;      // of yarn that turns
constexpr double one_over_other = 1.5;  // diameters in depth: yarn further apart lies beside, not over other yarn
constexpr double long_wait = 2.5;       // courses that a carrier was left out of
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

/// Whether yarn passes between loops of both beds: there are two sheets, or more than one layer.
bool is_layered(const StitchGraph& graph, const Surroundings& around) {
  const auto opposite = [&](int a, int b) {
    return on_back(graph.loops[static_cast<std::size_t>(a)].needle) !=
           on_back(graph.loops[static_cast<std::size_t>(b)].needle);
  };
  const auto crosses_the_other_bed = [&](const YarnStep& step) {
    const std::vector<int>& passed = step.legs.front().passed;
    return !step.turns && std::any_of(passed.begin(), passed.end(),
                                      [&](int loop) { return opposite(loop, step.to) || opposite(loop, step.from); });
  };
  return std::any_of(around.across.begin(), around.across.end(), [](int loop) { return loop >= 0; }) ||
         std::any_of(around.steps.begin(), around.steps.end(), crosses_the_other_bed);
}

/// Finds where everything lies: stitches pull their neighbours to the distances of a loose fabric.
class Arranging {
 public:
  Arranging(const StitchGraph& graph, const LoopSize& size, double diameter, const Surroundings& around,
            const std::optional<Tube>& tube, Arrangement& of)
      : graph_(graph),
        size_(size),
        diameter_(diameter),
        across_(around.across),
        tube_(tube),
        layered_(!tube && is_layered(graph, around)),
        of_(of),
        chained_(chained_loops(graph, of)),
        raised_(raised_in_row(graph, chained_)),
        columns_per_needle_(tube ? tube->per_needle : columns_per_needle(graph, of.steps)) {
    if (!tube) return;
    const double round = tube->round * size.wale();
    of.strip = {round, of.loops.front().heading * size.pitch / round};
  }

  void solve() {
    place(0, columns());
    place(0, across());
    place(2, sheets());
    levels_ = levels_of(graph_, of_, chained_, one_over_other * diameter_);
    place(1, upwards());
    if (layered_) lift();
    turn_up(of_, raised_, size_);
    find_waiting();
    for (std::size_t i = 0; i < of_.loops.size(); ++i) of_.loops[i].chained = chained_[i];
  }

 private:
  void place(int direction, const Eigen::VectorXd& values) {
    for (std::size_t i = 0; i < of_.anchors.size(); ++i)
      of_.anchors[i].at(direction) = values(static_cast<Eigen::Index>(i));
  }

  const Loop& loop(int i) const { return graph_.loops[static_cast<std::size_t>(i)]; }
  const Hanging& at(int i) const { return of_.loops[static_cast<std::size_t>(i)]; }
  double level(int i) const { return levels_[static_cast<std::size_t>(i)]; }

  /// How far transfers moved a loop, m.
  double shift(int i) const {
    const Loop& of = loop(i);
    const double needles = position(of.last_needle, of.last_racking) - position(of.needle, of.racking);
    return (tube_ ? tube_->side[static_cast<std::size_t>(i)] : 1) * needles * columns_per_needle_ * size_.wale();
  }

  /// A loop leans as far as it was moved; but rows that were moved far as they were stay over each other. In a bind-off
  /// a loop lies along the edge: the next loop of its own yarn is pulled through it.
  double sideways(int i) const {
    if (chained_[static_cast<std::size_t>(i)]) return at(i).heading * size_.wale();
    const bool alone = !at(i).passes && of_.anchors[static_cast<std::size_t>(first_head(i))].heads.size() == 1;
    return alone ? std::clamp(shift(i), -size_.wale(), size_.wale()) : shift(i);
  }

  const Vec3& anchor(int i) const { return of_.anchors[static_cast<std::size_t>(i)].at; }

  /// Where the program made each loop, or left it.
  double made_at(int i) const {
    if (tube_) return size_.wale() * tube_->column[static_cast<std::size_t>(i)];
    return size_.wale() * columns_per_needle_ * position(loop(i).needle, loop(i).racking);
  }

  Eigen::VectorXd columns() const {
    Eigen::VectorXd x(static_cast<Eigen::Index>(of_.anchors.size()));
    for (std::size_t i = 0; i < of_.anchors.size(); ++i) {
      const Anchor& at = of_.anchors[i];
      x(static_cast<Eigen::Index>(i)) = made_at(at.feet.empty() ? at.heads.front() : at.feet.front());
    }
    return x;
  }

  /// A spring between two places of a tube pulls the short way round.
  void pull_across(Springs& springs, int a, int b, double difference, double weight) const {
    const double turns = of_.strip.turns_from(anchor(a).x() + difference, anchor(b).x());
    springs.between(a, b, difference - turns * of_.strip.round, weight);
  }

  void pull_up(Springs& springs, int a, int b, double difference, double weight) const {
    const double turns = of_.strip.turns_from(anchor(a).x(), anchor(b).x());
    springs.between(a, b, difference + turns * of_.strip.climb * of_.strip.round, weight);
  }

  int first_head(int i) const { return at(i).via >= 0 ? at(i).via : at(i).head; }
  int first_foot(int anchor) const { return of_.anchors[static_cast<std::size_t>(anchor)].feet.front(); }
  int sign_of(int anchor) const { return at(first_foot(anchor)).sign; }

  /// Courses from the first loop pulled through a split one to the second.
  double split_rise(int i) const {
    return std::max(over_other, level(first_foot(at(i).head)) - level(first_foot(at(i).via)));
  }

  /// Courses from a loop's feet to its head: a loop that waits on its needle is drawn long, and so is one that leans so
  /// far that its legs would lie on each other.
  double rise(int i) const {
    if (chained_[static_cast<std::size_t>(i)]) return 0;
    const Anchor& head = of_.anchors[static_cast<std::size_t>(first_head(i))];
    const double rise = head.feet.empty() ? 1 : std::max(least_rise, level(head.feet.front()) - level(i));
    const Vec3& feet = anchor(at(i).feet);
    const double lean = std::abs(of_.strip.near(feet.x(), head.at).x() - feet.x());
    return std::max(rise, lean / (steepest_lean * size_.pitch));
  }

  Eigen::VectorXd upwards() const {
    Springs springs(of_.anchors.size());
    for (int i = 0; i < static_cast<int>(of_.loops.size()); ++i) {
      const double n = rise(i);
      pull_up(springs, at(i).feet, first_head(i), n * size_.pitch, 1 / std::max(1.0, n * n));
      if (at(i).via >= 0) pull_up(springs, at(i).via, at(i).head, split_rise(i) * size_.pitch, 1);
      springs.towards(at(i).feet, level(i) * size_.pitch, faint);
    }
    for (const YarnStep& step : of_.steps) {
      const int steps_up = raised_[static_cast<std::size_t>(step.to)] - raised_[static_cast<std::size_t>(step.from)];
      const int from = at(step.from).feet, to = at(step.to).feet;
      if (!step.turns) pull_up(springs, from, to, steps_up * size_.pitch, step.apart > 3 ? 0.1 : row_pull);
      // A column that is knitted every other row, as at the side of some ribs, keeps up with its neighbours.
      if (step.turns && step.to == step.from + 1 && to != at(step.from).head) pull_up(springs, from, to, 0, turn_pull);
    }
    return springs.rest();
  }

  Eigen::VectorXd across() const {
    Springs springs(of_.anchors.size());
    for (int i = 0; i < static_cast<int>(of_.loops.size()); ++i) {
      if (at(i).via >= 0) pull_across(springs, at(i).via, at(i).head, 0, 1);
      pull_across(springs, at(i).feet, first_head(i), sideways(i), 1);
      springs.towards(at(i).feet, made_at(i), faint);
    }
    for (const YarnStep& step : of_.steps) {
      const double wales = at(step.to).heading * step.apart;
      if (step.turns)
        pull_across(springs, at(step.from).feet, at(step.to).feet, made_at(step.to) - made_at(step.from), turn_pull);
      else
        pull_across(springs, at(step.from).feet, at(step.to).feet, wales * size_.wale(), 1.0 / (wales * wales));
    }
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
      const double pull = !layered_ ? faint : across_[static_cast<std::size_t>(i)] >= 0 ? back_to_back : sheet_pull;
      springs.towards(at(i).feet, layered_ ? at(i).sign * sheet_distance * diameter_ : 0, pull);
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
      if (std::abs(feet.y() - facing.y()) < over_other / 2 * size_.pitch) above.push_back(&feet);
    }
    for (Vec3* feet : above) feet->y() += over_other * size_.pitch;
  }

  void find_waiting() {
    for (YarnStep& step : of_.steps) {
      const Vec3& from = anchor(at(step.from).feet);
      const Vec3 to = of_.strip.near(from.x(), anchor(at(step.to).feet));
      step.waits = std::abs(to.y() - from.y()) > long_wait * size_.pitch;
    }
  }

  const StitchGraph& graph_;
  const LoopSize& size_;
  double diameter_;
  const std::vector<int>& across_;
  const std::optional<Tube>& tube_;
  bool layered_;
  Arrangement& of_;
  std::vector<bool> chained_;
  std::vector<double> levels_;
  std::vector<int> raised_;
  double columns_per_needle_;
};

}  // namespace

Arrangement arrange(const StitchGraph& graph, const LoopSize& size, double diameter) {
  Arrangement arrangement = hang(graph);
  const Surroundings around = surroundings(graph);
  arrangement.steps = around.steps;
  leave_room(graph, arrangement.steps);
  mark_crossing_loops(graph, arrangement);
  const std::optional<Tube> tube = find_tube(graph);
  if (tube) see_from_outside(*tube, arrangement);
  Arranging(graph, size, diameter, around, tube, arrangement).solve();
  return arrangement;
}

}  // namespace wale::passes
