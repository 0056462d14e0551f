#include "compiler/passes/surroundings.hpp"

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

  /// The last loop on the needle across the gap; -1 if there is none.
  int across(const Needle& needle, double racking) const {
    const double index = on_back(needle) ? needle.index + racking : needle.index - racking;
    const auto& bed = beds_[!on_back(needle)];
    const auto at = bed.find(static_cast<int>(std::lround(index)));
    return index != std::round(index) || at == bed.end() || at->second.empty() ? -1 : at->second.back();
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
  YarnStep step;
  step.from = from;
  step.to = to;
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

Surroundings surroundings(const StitchGraph& graph) {
  const std::vector<int> before = loops_before(graph);
  std::vector<YarnStep> to(graph.loops.size());  // the step that leads to each loop
  Surroundings found;
  Needles needles(graph);
  for (std::size_t i = 0; i < graph.loops.size(); ++i) {
    const Loop& loop = graph.loops[i];
    needles.go_to(loop.instruction);
    found.across.push_back(needles.across(loop.needle, loop.racking));
    if (before[i] >= 0) to[i] = step_between(graph, before[i], static_cast<int>(i), needles);
  }
  for (const YarnPath& yarn : graph.yarns)
    for (std::size_t k = 1; k < yarn.loops.size(); ++k)
      found.steps.push_back(std::move(to[static_cast<std::size_t>(yarn.loops[k])]));
  return found;
}

}  // namespace wale
