#include "compiler/passes/yarn_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace wale {
namespace {

/// Something that happens to a loop: it comes to a needle, or leaves one.
struct Event {
  int instruction = 0, loop = 0;
  Needle needle;
  bool comes = false;
};

std::vector<Event> events_of(const StitchGraph& graph) {
  std::vector<Event> events;
  for (int i = 0; i < static_cast<int>(graph.loops.size()); ++i) {
    const Loop& loop = graph.loops[static_cast<std::size_t>(i)];
    Needle on = loop.needle;
    events.push_back({loop.instruction, i, on, true});
    for (const Move& move : loop.moves) {
      events.push_back({move.instruction, i, on, false});
      events.push_back({move.instruction, i, move.to, true});
      on = move.to;
    }
    if (loop.released >= 0) events.push_back({loop.released, i, on, false});
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.instruction < b.instruction; });
  return events;
}

/// The loops on the needles, as the program goes on.
class Needles {
 public:
  explicit Needles(const StitchGraph& graph) : events_(events_of(graph)) {}

  /// To the moment before an instruction; never back.
  void go_to(int instruction) {
    for (; next_ < events_.size() && events_[next_].instruction < instruction; ++next_) {
      const Event& event = events_[next_];
      std::vector<int>& stack = beds_[on_back(event.needle)][event.needle.index];
      if (event.comes)
        stack.push_back(event.loop);
      else
        stack.erase(std::remove(stack.begin(), stack.end(), event.loop), stack.end());
    }
  }

  /// The last loop of every needle of a bed between two positions, from left to right.
  std::vector<int> between(double low, double high, bool back, double racking) const {
    std::vector<int> loops;
    const double shift = back ? racking : 0;
    const auto& bed = beds_[back];
    for (auto at = bed.upper_bound(static_cast<int>(std::floor(low - shift))); at != bed.end(); ++at) {
      if (at->first + shift >= high) break;
      if (at->first + shift > low && !at->second.empty()) loops.push_back(at->second.back());
    }
    return loops;
  }

 private:
  std::vector<Event> events_;
  std::size_t next_ = 0;
  std::array<std::map<int, std::vector<int>>, 2> beds_;  // front with its sliders, back with its sliders
};

YarnStep step_between(const StitchGraph& graph, int from, int to, const Needles& needles) {
  const Loop &before = graph.loops[static_cast<std::size_t>(from)], &after = graph.loops[static_cast<std::size_t>(to)];
  YarnStep step{from, to, false, 1, {}};
  const double x = position(before.needle, before.racking), next = position(after.needle, after.racking);
  const int heading = after.direction == Direction::decreasing ? -1 : 1;
  step.turns = before.direction != after.direction || heading * (next - x) < 0;
  const double low = std::min(x, next), high = std::max(x, next);
  const auto front = needles.between(low, high, false, after.racking);
  const auto back = needles.between(low, high, true, after.racking);
  const bool same_bed = on_back(before.needle) == on_back(after.needle);
  const auto& beside = on_back(after.needle) ? back : front;
  step.apart = 1 + static_cast<int>(same_bed ? beside.size() : std::max(front.size(), back.size()));
  step.passed = front;
  step.passed.insert(step.passed.end(), back.begin(), back.end());
  return step;
}

}  // namespace

std::vector<YarnStep> yarn_steps(const StitchGraph& graph) {
  struct Pair {
    int from, to;
  };
  std::vector<Pair> pairs;
  for (const YarnPath& yarn : graph.yarns)
    for (std::size_t k = 1; k < yarn.loops.size(); ++k) pairs.push_back({yarn.loops[k - 1], yarn.loops[k]});

  std::vector<std::size_t> order(pairs.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return pairs[a].to < pairs[b].to; });

  Needles needles(graph);
  std::vector<YarnStep> steps(pairs.size());
  for (const std::size_t i : order) {
    needles.go_to(graph.loops[static_cast<std::size_t>(pairs[i].to)].instruction);
    steps[i] = step_between(graph, pairs[i].from, pairs[i].to, needles);
  }
  return steps;
}

}  // namespace wale
