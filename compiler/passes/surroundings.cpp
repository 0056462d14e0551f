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

  /// A needle's last loop, where that needle stands.
  struct Standing {
    double at = 0;
    int loop = -1;
  };

  /// Of every needle of a bed between two positions, from left to right.
  std::vector<Standing> between(double low, double high, bool back, double racking) const {
    std::vector<Standing> loops;
    const double shift = back ? racking : 0;
    const auto& bed = beds_[back];
    for (auto at = bed.upper_bound(static_cast<int>(std::floor(low - shift))); at != bed.end(); ++at) {
      if (at->first + shift >= high) break;
      if (at->first + shift > low && !at->second.empty()) loops.push_back({at->first + shift, at->second.back()});
    }
    return loops;
  }

 private:
  std::vector<Event> events_;
  std::size_t next_ = 0;
  std::array<std::map<int, std::vector<int>>, 2> beds_;  // front with its sliders, back with its sliders
};

/// Where a carrier was, and which way it went there.
struct Waypoint {
  Needle needle;
  double at = 0;
  int heading = 1;
  bool stitch = true;  // else a miss
  int instruction = 0;
};

Waypoint waypoint(const Needle& needle, double racking, Direction direction, bool stitch, int instruction) {
  return {needle, position(needle, racking), direction == Direction::decreasing ? -1 : 1, stitch, instruction};
}
Waypoint waypoint(const Loop& loop) {
  return waypoint(loop.needle, loop.racking, loop.direction, true, loop.instruction);
}
Waypoint waypoint(const Miss& miss) {
  return waypoint(miss.needle, miss.racking, miss.direction, false, miss.instruction);
}

bool turns_between(const Waypoint& from, const Waypoint& to) {
  return from.heading != to.heading || to.heading * (to.at - from.at) < 0;
}

/// The loops of both beds between two waypoints, in the order in which yarn passes them. Where it turns it has gone
/// past the needle that it left, or goes past the one that it comes to; a needle that it misses it always passes.
Leg leg_between(const Waypoint& from, const Waypoint& to, double racking, const Needles& needles) {
  constexpr double past = 0.5;
  const int side = to.at < from.at || (to.at == from.at && to.heading < 0) ? -1 : 1;
  const double begin = from.at - (from.heading == side ? 0 : past * side);
  const bool ahead = to.heading == side;
  const double end = to.at + past * side * (to.stitch ? (ahead ? 0 : 1) : (ahead ? 1 : -0.5));
  Leg leg{side, {}};
  if (side * (end - begin) <= 0) return leg;
  const double low = std::min(begin, end), high = std::max(begin, end);
  std::vector<Needles::Standing> passed = needles.between(low, high, false, racking);
  const std::vector<Needles::Standing> back = needles.between(low, high, true, racking);
  passed.insert(passed.end(), back.begin(), back.end());
  std::stable_sort(passed.begin(), passed.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
  for (const Needles::Standing& each : passed) leg.passed.push_back(each.loop);
  if (side < 0) std::reverse(leg.passed.begin(), leg.passed.end());
  return leg;
}

/// How many columns lie between two stitches, counted on the bed of both or on the fuller one.
int columns_between(const Waypoint& from, const Waypoint& to, double racking, const Needles& needles) {
  const double low = std::min(from.at, to.at), high = std::max(from.at, to.at);
  const std::size_t front = needles.between(low, high, false, racking).size(),
                    back = needles.between(low, high, true, racking).size();
  if (on_back(from.needle) == on_back(to.needle)) return 1 + static_cast<int>(on_back(to.needle) ? back : front);
  return 1 + static_cast<int>(std::max(front, back));
}

/// Follows each yarn from stitch to stitch and over the needles that it misses, as the program goes on.
class Trails {
 public:
  explicit Trails(const StitchGraph& graph) : graph_(graph), step_to_(graph.loops.size()) {}

  std::vector<YarnStep> follow(std::vector<int>& across) {
    Needles needles(graph_);
    for (const Event& event : events()) {
      needles.go_to(event.to.instruction);
      go(event, needles);
      if (event.loop < 0) continue;
      const Loop& loop = graph_.loops[static_cast<std::size_t>(event.loop)];
      across[static_cast<std::size_t>(event.loop)] = needles.across(loop.needle, loop.racking);
    }
    std::vector<YarnStep> steps;
    for (const YarnPath& yarn : graph_.yarns)
      for (std::size_t k = 1; k < yarn.loops.size(); ++k)
        steps.push_back(std::move(step_to_[static_cast<std::size_t>(yarn.loops[k])]));
    return steps;
  }

 private:
  struct Event {
    Waypoint to;
    std::size_t yarn = 0;
    int loop = -1;  // -1 for a miss
    double racking = 0;
  };
  struct Trail {
    int loop = -1;  // that it comes from
    Waypoint at;
    std::vector<Leg> legs;
  };

  std::vector<Event> events() {
    std::vector<Event> all;
    for (std::size_t y = 0; y < graph_.yarns.size(); ++y) {
      const YarnPath& yarn = graph_.yarns[y];
      for (const int i : yarn.loops) {
        const Loop& loop = graph_.loops[static_cast<std::size_t>(i)];
        all.push_back({waypoint(loop), y, i, loop.racking});
      }
      for (const Miss& miss : yarn.misses) all.push_back({waypoint(miss), y, -1, miss.racking});
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Event& a, const Event& b) { return a.to.instruction < b.to.instruction; });
    trails_.resize(graph_.yarns.size());
    return all;
  }

  void go(const Event& event, const Needles& needles) {
    Trail& trail = trails_[event.yarn];
    if (trail.loop >= 0) {
      go_on(trail.legs, leg_between(trail.at, event.to, event.racking, needles));
      if (event.loop >= 0) arrive(trail, event, needles);
    }
    trail.at = event.to;
    if (event.loop >= 0) trail.loop = event.loop;
  }

  /// What yarn passes there and back again holds nothing.
  static void go_on(std::vector<Leg>& legs, Leg next) {
    while (!legs.empty() && legs.back().side != next.side) {
      std::vector<int>& before = legs.back().passed;
      std::size_t undone = 0;
      while (undone < std::min(before.size(), next.passed.size()) &&
             before[before.size() - 1 - undone] == next.passed[undone])
        ++undone;
      before.resize(before.size() - undone);
      next.passed.erase(next.passed.begin(), next.passed.begin() + static_cast<std::ptrdiff_t>(undone));
      if (!before.empty()) break;
      legs.pop_back();
    }
    if (!legs.empty() && legs.back().side == next.side)
      legs.back().passed.insert(legs.back().passed.end(), next.passed.begin(), next.passed.end());
    else
      legs.push_back(std::move(next));
  }

  void arrive(Trail& trail, const Event& event, const Needles& needles) {
    const Waypoint from = waypoint(graph_.loops[static_cast<std::size_t>(trail.loop)]);
    YarnStep& step = step_to_[static_cast<std::size_t>(event.loop)];
    step.from = trail.loop;
    step.to = event.loop;
    step.turns = turns_between(from, event.to) || trail.legs.size() > 1;
    step.apart = columns_between(from, event.to, event.racking, needles);
    step.legs = std::move(trail.legs);
    trail.legs.clear();
  }

  const StitchGraph& graph_;
  std::vector<YarnStep> step_to_;  // by loop
  std::vector<Trail> trails_;      // by yarn
};

}  // namespace

Surroundings surroundings(const StitchGraph& graph) {
  Surroundings found;
  found.across.assign(graph.loops.size(), -1);
  found.steps = Trails(graph).follow(found.across);
  return found;
}

}  // namespace wale
