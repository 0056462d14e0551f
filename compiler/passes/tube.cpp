#include "compiler/passes/tube.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace wale {
namespace {

constexpr double least_width = 0.7;  // of the widest round: narrower ones would have to be drawn too long

constexpr int never = std::numeric_limits<int>::max();

int half_of(const Loop& loop) { return loop.direction == Direction::decreasing ? 1 : 0; }

/// On which bed a loop waits when the other half is knitted on, `then`: +1 the front, -1 the back, 0 if it does not
/// wait.
int home_of(const Loop& loop, int then) {
  if (loop.released >= 0 && loop.released <= then) return 0;
  Needle on = loop.needle;
  for (const Move& move : loop.moves)
    if (move.instruction < then) on = move.to;
  return on_back(on) ? -1 : 1;
}

/// The bed of each half, by direction; {0, 0} if a half lies on both, or both on one.
std::array<int, 2> beds_of_halves(const StitchGraph& graph) {
  std::array<int, 2> bed{0, 0}, next{never, never};  // the next loop made in each half
  for (auto loop = graph.loops.rbegin(); loop != graph.loops.rend(); ++loop) {
    const auto half = static_cast<std::size_t>(half_of(*loop));
    const int home = home_of(*loop, next[1 - half]);
    if (home != 0 && bed[half] == -home) return {0, 0};
    if (home != 0) bed[half] = home;
    next[half] = loop->instruction;
  }
  return bed[0] == -bed[1] ? bed : std::array<int, 2>{0, 0};
}

/// A bind-off alone leads from one half to the other, where the yarn is pulled through the loop that it made last.
bool halves_are_apart(const StitchGraph& graph) {
  const std::vector<int> before = loops_before(graph);
  for (std::size_t i = 0; i < graph.loops.size(); ++i)
    for (const int parent : graph.loops[i].through)
      if (parent != before[i] && graph.loops[static_cast<std::size_t>(parent)].direction != graph.loops[i].direction)
        return false;
  return true;
}

/// How often yarn turns into each half, and how many loops it knits in a half, from where it is whole on.
struct Rounds {
  std::array<int, 2> turns{0, 0};
  int widest = 0, narrowest = std::numeric_limits<int>::max();

  void count(const StitchGraph& graph, const YarnPath& yarn) {
    std::optional<int> knits;  // since the last turn
    const Loop* before = nullptr;
    for (const int i : yarn.loops) {
      const Loop& loop = graph.loops[static_cast<std::size_t>(i)];
      if (before && before->direction != loop.direction) {
        ++turns[static_cast<std::size_t>(half_of(loop))];
        if (knits.value_or(0) > 0) widest = std::max(widest, *knits), narrowest = std::min(narrowest, *knits);
        knits = 0;
      }
      if (knits && !loop.through.empty()) ++*knits;
      before = &loop;
    }
  }
};

/// Whether yarn goes round both sides, and never round much less than the widest part.
bool goes_round(const StitchGraph& graph) {
  Rounds rounds;
  for (const YarnPath& yarn : graph.yarns) rounds.count(graph, yarn);
  return rounds.turns[0] > 0 && rounds.turns[1] > 0 &&
         (rounds.widest == 0 || rounds.narrowest >= least_width * rounds.widest);
}

/// The needles of a half, as they stand along the front bed, each a column.
class Columns {
 public:
  static int needle(const Loop& loop) { return static_cast<int>(std::lround(position(loop.needle, loop.racking))); }
  void take(const Loop& loop) { needles_.insert(needle(loop)); }
  int count() const { return static_cast<int>(needles_.size()); }
  int from_left(const Loop& loop) const {
    return static_cast<int>(std::distance(needles_.begin(), needles_.find(needle(loop))));
  }
  double per_needle() const { return count() / (1.0 + *needles_.rbegin() - *needles_.begin()); }

 private:
  std::set<int> needles_;
};

}  // namespace

std::optional<Tube> find_tube(const StitchGraph& graph) {
  if (graph.loops.empty()) return {};
  const std::array<int, 2> bed = beds_of_halves(graph);
  if (bed[0] == 0 || !halves_are_apart(graph) || !goes_round(graph)) return {};
  Tube tube;
  Columns front, back;
  for (const Loop& loop : graph.loops) {
    tube.side.push_back(bed[static_cast<std::size_t>(half_of(loop))]);
    (tube.side.back() > 0 ? front : back).take(loop);
  }
  tube.round = front.count() + back.count();
  tube.per_needle = std::max(front.per_needle(), back.per_needle());
  for (std::size_t i = 0; i < graph.loops.size(); ++i)
    tube.column.push_back(tube.side[i] > 0 ? front.from_left(graph.loops[i])
                                           : tube.round - 1 - back.from_left(graph.loops[i]));
  const int first = tube.column.front();
  const bool leftwards = (half_of(graph.loops.front()) == 1) != (tube.side.front() < 0);
  for (int& column : tube.column) {
    column = (column - first + tube.round) % tube.round;
    if (leftwards && column == 0) column = tube.round;
  }
  return tube;
}

void see_from_outside(const Tube& tube, Arrangement& of) {
  for (std::size_t i = 0; i < of.loops.size(); ++i) {
    of.loops[i].half = tube.side[i];
    of.loops[i].sign *= tube.side[i];
    of.loops[i].heading *= tube.side[i];
    of.loops[i].passes *= tube.side[i];
  }
  for (Anchor& anchor : of.anchors)
    for (std::vector<int>* stack : {&anchor.heads, &anchor.feet})
      if (!stack->empty() && tube.side[static_cast<std::size_t>(stack->front())] < 0)
        std::reverse(stack->begin(), stack->end());
  for (YarnStep& step : of.steps) {
    const int heading = of.loops[static_cast<std::size_t>(step.to)].heading;
    int ahead =
        heading * (tube.column[static_cast<std::size_t>(step.to)] - tube.column[static_cast<std::size_t>(step.from)]);
    ahead -= tube.round * static_cast<int>(std::lround(static_cast<double>(ahead) / tube.round));
    step.turns = of.loops[static_cast<std::size_t>(step.from)].heading != heading || ahead < 0;
    step.apart = std::max(1, std::abs(ahead));
  }
}

}  // namespace wale
