#include <utility>

#include "compiler/passes.hpp"

namespace wale::passes {
namespace {

/// By loop: made of nothing, let go of before anything was pulled through it.
std::vector<bool> slack_loops(const StitchGraph& graph) {
  std::vector<bool> slack;
  for (const Loop& loop : graph.loops) slack.push_back(loop.dropped && loop.through.empty());
  return slack;
}

Miss missed(const Loop& loop, int loops_before) {
  return {loops_before, loop.needle, loop.direction, loop.racking, loop.instruction};
}

}  // namespace

StitchGraph let_run(const StitchGraph& graph) {
  const std::vector<bool> slack = slack_loops(graph);
  StitchGraph rest;
  rest.carriers = graph.carriers;
  rest.widest = graph.widest;
  rest.on_needles = graph.on_needles;
  std::vector<int> number;
  for (std::size_t i = 0; i < graph.loops.size(); ++i) {
    number.push_back(slack[i] ? -1 : static_cast<int>(rest.loops.size()));
    if (!slack[i]) rest.loops.push_back(graph.loops[i]);
  }
  const auto renumber = [&number](std::vector<int>& loops) {
    for (int& loop : loops) loop = number[static_cast<std::size_t>(loop)];
  };
  for (Loop& loop : rest.loops) renumber(loop.through);
  for (HeldLoops& needle : rest.on_needles) renumber(needle.loops);
  for (YarnPath yarn : graph.yarns) {
    const std::vector<int> loops = std::exchange(yarn.loops, {});
    const std::vector<Miss> misses = std::exchange(yarn.misses, {});
    std::size_t next = 0;
    for (std::size_t k = 0; k <= loops.size(); ++k) {
      const auto kept = static_cast<int>(yarn.loops.size());
      for (; next < misses.size() && misses[next].loops_before <= static_cast<int>(k); ++next) {
        yarn.misses.push_back(misses[next]);
        yarn.misses.back().loops_before = kept;
      }
      if (k == loops.size()) break;
      const auto loop = static_cast<std::size_t>(loops[k]);
      if (slack[loop])
        yarn.misses.push_back(missed(graph.loops[loop], kept));
      else
        yarn.loops.push_back(number[loop]);
    }
    rest.yarns.push_back(std::move(yarn));
  }
  return rest;
}

}  // namespace wale::passes
