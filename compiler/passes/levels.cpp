#include "compiler/passes/levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace wale {
namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void take(double x) { low = std::min(low, x), high = std::max(high, x); }
};

/// Yarn that one pass of a carrier laid on needles, from stitch to stitch.
struct Laid {
  Range x;
  double z = 0, level = 0;
};

class Levels {
 public:
  Levels(const StitchGraph& graph, const Arrangement& arrangement, const std::vector<bool>& chained, double apart)
      : graph_(graph), arrangement_(arrangement), chained_(chained), apart_(apart), of_(graph.loops.size(), 0) {}

  std::vector<double> find() {
    const std::vector<int> before = loops_before(graph_);
    std::vector<int> after(before.size(), -1);
    for (std::size_t i = 0; i < before.size(); ++i)
      if (before[i] >= 0) after[static_cast<std::size_t>(before[i])] = static_cast<int>(i);
    std::vector<bool> done(before.size(), false);
    for (int i = 0; i < static_cast<int>(of_.size()); ++i) {
      if (done[static_cast<std::size_t>(i)]) continue;
      if (!loop(i).through.empty()) {
        level(i) = above(i);
        continue;
      }
      std::vector<int> row{i};
      for (int next = after[static_cast<std::size_t>(i)]; next >= 0 && goes_on(row.back(), next);
           next = after[static_cast<std::size_t>(next)])
        row.push_back(next);
      lay(row, before[static_cast<std::size_t>(i)]);
      for (const int laid : row) done[static_cast<std::size_t>(laid)] = true;
    }
    return of_;
  }

 private:
  const Loop& loop(int i) const { return graph_.loops[static_cast<std::size_t>(i)]; }
  const Hanging& at(int i) const { return arrangement_.loops[static_cast<std::size_t>(i)]; }
  const Vec3& feet(int i) const { return arrangement_.anchors[static_cast<std::size_t>(at(i).feet)].at; }
  double& level(int i) { return of_[static_cast<std::size_t>(i)]; }

  double above(int i) {
    double highest = 0;
    for (const int parent : loop(i).through)
      highest = std::max(highest, std::floor(level(parent)) + (chained_[static_cast<std::size_t>(parent)] ? 0 : 1));
    return highest;
  }

  /// Whether the next loop belongs to the same row of a cast-on, or of tucks.
  bool goes_on(int from, int to) const {
    return loop(to).through.empty() && loop(to).course == loop(from).course && at(to).heading == at(from).heading &&
           hangs_with_none(from) && hangs_with_none(to);
  }

  /// No knitted loop is in the hook.
  bool hangs_with_none(int i) const {
    const std::vector<int>& hook = arrangement_.anchors[static_cast<std::size_t>(at(i).head)].heads;
    return std::none_of(hook.begin(), hook.end(), [&](int with) { return with < i && !loop(with).through.empty(); });
  }

  void lay(const std::vector<int>& row, int before) {
    double base = before >= 0 ? std::floor(level(before)) : 0;
    Laid laid;
    for (const int i : row) {
      for (const int with : arrangement_.anchors[static_cast<std::size_t>(at(i).head)].heads)
        if (with < i && !loop(with).through.empty()) base = std::max(base, std::floor(level(with)) + 1);
      laid.x.take(arrangement_.strip.near(feet(row.front()).x(), feet(i)).x());
      laid.z += feet(i).z() / static_cast<double>(row.size());
    }
    laid.level = base;
    std::vector<Laid>& others = laid_[static_cast<int>(base)];
    for (const Laid& other : others)
      if (other.x.low <= laid.x.high && other.x.high >= laid.x.low && std::abs(other.z - laid.z) < apart_)
        laid.level = std::max(laid.level, other.level + over_other);
    others.push_back(laid);
    for (const int i : row) level(i) = laid.level;
  }

  const StitchGraph& graph_;
  const Arrangement& arrangement_;
  const std::vector<bool>& chained_;
  double apart_;
  std::vector<double> of_;
  std::map<int, std::vector<Laid>> laid_;  // by course
};

}  // namespace

std::vector<bool> chained_loops(const StitchGraph& graph, const Arrangement& arrangement) {
  constexpr std::size_t most_tucks = 2;  // a bind-off may tuck on the other bed on its way
  std::vector<bool> chained(graph.loops.size(), false);
  for (const YarnPath& yarn : graph.yarns)
    for (std::size_t k = 1; k < yarn.loops.size(); ++k) {
      const auto child = static_cast<std::size_t>(yarn.loops[k]);
      const std::vector<int>& through = graph.loops[child].through;
      for (std::size_t back = 1; back <= std::min(1 + most_tucks, k); ++back) {
        const auto before = static_cast<std::size_t>(yarn.loops[k - back]);
        const bool held = std::find(through.begin(), through.end(), yarn.loops[k - back]) != through.end();
        const bool ahead = arrangement.loops[before].heading == arrangement.loops[child].heading &&
                           graph.loops[before].needle != graph.loops[child].needle;
        if (held && ahead) chained[before] = true;
        if (held || !graph.loops[before].through.empty()) break;
      }
    }
  return chained;
}

std::vector<double> levels_of(const StitchGraph& graph, const Arrangement& arrangement,
                              const std::vector<bool>& chained, double apart) {
  return Levels(graph, arrangement, chained, apart).find();
}

std::vector<int> raised_in_row(const StitchGraph& graph, const std::vector<bool>& chained) {
  std::vector<int> raised(graph.loops.size(), 0);
  for (std::size_t i = 0; i < graph.loops.size(); ++i) {
    const Loop& loop = graph.loops[i];
    for (const int through : loop.through) {
      const auto parent = static_cast<std::size_t>(through);
      const bool of_this_pass =
          graph.loops[parent].carrier == loop.carrier && graph.loops[parent].course == loop.course;
      if (of_this_pass && !chained[parent]) raised[i] = std::max(raised[i], raised[parent] + 1);
    }
  }
  return raised;
}

}  // namespace wale
