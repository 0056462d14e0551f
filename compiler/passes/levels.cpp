#include "compiler/passes/levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace wale {
namespace {

constexpr double most_over_itself = 0.6;

class Levels {
 public:
  Levels(const StitchGraph& graph, const Arrangement& arrangement, const std::vector<bool>& chained)
      : graph_(graph), arrangement_(arrangement), chained_(chained), of_(graph.loops.size(), 0) {}

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
    auto& passes = passes_[{loop(i).carrier, own.half != 0 ? own.half : own.sign, static_cast<int>(along)}];
    passes.insert(loop(i).course);
    return highest + std::min(most_over_itself, over_itself * static_cast<double>(passes.size() - 1));
  }

  const StitchGraph& graph_;
  const Arrangement& arrangement_;
  const std::vector<bool>& chained_;
  std::vector<double> of_;
  std::map<std::array<int, 3>, std::set<int>> passes_;  // by carrier, sheet and course
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
        if (arrangement.loops[before].heading != arrangement.loops[child].heading) break;
        const bool ahead = graph.loops[before].needle != graph.loops[child].needle;
        if (ahead && std::find(through.begin(), through.end(), yarn.loops[k - back]) != through.end())
          chained[before] = true;
        if (!graph.loops[before].through.empty()) break;
      }
    }
  return chained;
}

std::vector<double> levels_of(const StitchGraph& graph, const Arrangement& arrangement,
                              const std::vector<bool>& chained) {
  return Levels(graph, arrangement, chained).find();
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
