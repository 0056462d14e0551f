#include <fmt/format.h>

#include <cstdlib>
#include <vector>

#include "compiler/passes.hpp"
#include "compiler/passes/finding.hpp"
#include "compiler/passes/program_codes.hpp"

namespace wale::passes {
namespace {

constexpr int longest_float = 20;  // needles

/// The first course is made on empty needles. In a machine's own program it is the yarn's first pass, and the second
/// where a cast-on takes every other needle on the way there and the rest on the way back.
bool may_lack_a_parent(const Loop& loop) {
  return loop.kind == LoopKind::tuck || (loop.cell.course >= 0 ? loop.cell.course == 0 : loop.course <= 1);
}

std::vector<bool> parents(const StitchGraph& graph) {
  std::vector<bool> is_parent(graph.loops.size(), false);
  for (const Loop& loop : graph.loops)
    for (const int parent : loop.through) is_parent[static_cast<std::size_t>(parent)] = true;
  return is_parent;
}

Finding floats(const StitchGraph& graph) {
  Finding found;
  for (const YarnPath& yarn : graph.yarns)
    for (std::size_t i = 1; i < yarn.loops.size(); ++i) {
      const Needle& from = graph.loops[static_cast<std::size_t>(yarn.loops[i - 1])].needle;
      const Needle& to = graph.loops[static_cast<std::size_t>(yarn.loops[i])].needle;
      if (std::abs(to.index - from.index) > longest_float)
        found.add(graph.loops[static_cast<std::size_t>(yarn.loops[i])].span);
    }
  return found;
}

}  // namespace

void check_graph(const StitchGraph& graph, Diagnostics& say) {
  const auto warn = [&](const Finding& found, std::string_view code, std::string message, std::string hint) {
    tell_once(found, Severity::warning, code, std::move(message), std::move(hint), say);
  };
  const std::vector<bool> is_parent = parents(graph);
  Finding orphans, running;
  for (int i = 0; i < static_cast<int>(graph.loops.size()); ++i) {
    const Loop& loop = graph.loops[static_cast<std::size_t>(i)];
    if (loop.through.empty() && !may_lack_a_parent(loop)) orphans.add(loop.span);
    if (!loop.held && !is_parent[static_cast<std::size_t>(i)]) running.add(loop.span);
  }
  warn(orphans, codes::knit_on_empty, "a loop is knit on an empty needle", "tuck if a new loop is meant");
  warn(running, codes::loop_runs, "a loop holds nothing and nothing holds it: it will run",
       "knit it, or keep it on its needle");
  warn(floats(graph), codes::long_float, fmt::format("yarn floats past more than {} needles", longest_float),
       "tuck it on the way");
}

}  // namespace wale::passes
