#include "compiler/stitch_graph.hpp"

#include <fmt/format.h>

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

std::string print(const StitchGraph& graph) {
  std::string text;
  for (int i = 0; i < static_cast<int>(graph.loops.size()); ++i) print_loop(graph, i, text);
  for (const YarnPath& yarn : graph.yarns)
    fmt::format_to(std::back_inserter(text), "yarn {}: {} loops\n",
                   graph.carriers[static_cast<std::size_t>(yarn.carrier)], yarn.loops.size());
  return text;
}

}  // namespace wale
