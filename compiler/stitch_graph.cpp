#include "compiler/stitch_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace wale {
namespace {

void print_loop(const StitchGraph& graph, int i, std::string& text) {
  const Loop& loop = graph.loops[static_cast<std::size_t>(i)];
  fmt::format_to(std::back_inserter(text), "loop {}: {} {} {} yarn {} pass {}", i,
                 loop.kind == LoopKind::knit ? "knit" : "tuck", loop.direction == Direction::decreasing ? "-" : "+",
                 print(loop.needle), graph.carriers[static_cast<std::size_t>(loop.carrier)], loop.course);
  for (std::size_t k = 0; k < loop.through.size(); ++k)
    fmt::format_to(std::back_inserter(text), "{} {}", k == 0 ? " through" : "", loop.through[k]);
  if (loop.held) text += " held";
  if (loop.dropped) text += " dropped";
  text += "\n";
}

}  // namespace

std::vector<int> loops_before(const StitchGraph& graph) {
  std::vector<int> before(graph.loops.size(), -1);
  for (const YarnPath& yarn : graph.yarns)
    for (std::size_t i = 1; i < yarn.loops.size(); ++i)
      before[static_cast<std::size_t>(yarn.loops[i])] = yarn.loops[i - 1];
  return before;
}

std::vector<int> courses_of(const StitchGraph& graph) {
  std::vector<int> courses(graph.loops.size(), 0);
  const std::vector<int> previous = loops_before(graph);
  for (std::size_t i = 0; i < graph.loops.size(); ++i) {
    const Loop& loop = graph.loops[i];
    for (const int below : loop.through)
      courses[i] = std::max(courses[i], courses[static_cast<std::size_t>(below)] + 1);
    if (loop.through.empty() && previous[i] >= 0) courses[i] = courses[static_cast<std::size_t>(previous[i])];
  }
  return courses;
}

Needle needle_before(const Loop& loop, int instruction) {
  Needle on = loop.needle;
  for (const Move& move : loop.moves) {
    if (move.instruction >= instruction) break;
    on = move.to;
  }
  return on;
}

double longest_stitch(const StitchGraph& graph) {
  double longest = 0;
  for (const Loop& loop : graph.loops) longest = std::max(longest, loop.stitch_length);
  return longest;
}

std::string print(const StitchGraph& graph) {
  std::string text;
  for (int i = 0; i < static_cast<int>(graph.loops.size()); ++i) print_loop(graph, i, text);
  for (const YarnPath& yarn : graph.yarns)
    fmt::format_to(std::back_inserter(text), "yarn {}: {} loops\n",
                   graph.carriers[static_cast<std::size_t>(yarn.carrier)], yarn.loops.size());
  return text;
}

}  // namespace wale
