#include <fmt/format.h>

#include <cstdlib>
#include <vector>

#include "compiler/passes.hpp"
#include "compiler/passes/program_codes.hpp"

namespace wale::passes {
namespace {

constexpr int longest_float = 20;  // needles

/// One finding is reported for each kind, at the first place: a whole course of them is one mistake.
struct Finding {
  int first = -1;  // loop
  int count = 0;
  void add(int loop) {
    if (count++ == 0) first = loop;
  }
};

void warn(const StitchGraph& graph, const Finding& finding, std::string_view code, std::string message,
          std::string hint, Diagnostics& say) {
  if (finding.count == 0) return;
  if (finding.count > 1) message += fmt::format(" (and {} more)", finding.count - 1);
  say.warning(code, graph.loops[static_cast<std::size_t>(finding.first)].span, std::move(message), std::move(hint));
}

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
      if (std::abs(to.index - from.index) > longest_float) found.add(yarn.loops[i]);
    }
  return found;
}

}  // namespace

void check_graph(const StitchGraph& graph, Diagnostics& say) {
  const std::vector<bool> is_parent = parents(graph);
  Finding orphans, running;
  for (int i = 0; i < static_cast<int>(graph.loops.size()); ++i) {
    const Loop& loop = graph.loops[static_cast<std::size_t>(i)];
    if (loop.through.empty() && !may_lack_a_parent(loop)) orphans.add(i);
    if (!loop.held && !is_parent[static_cast<std::size_t>(i)]) running.add(i);
  }
  warn(graph, orphans, codes::knit_on_empty, "a loop is knit on an empty needle", "tuck if a new loop is meant", say);
  warn(graph, running, codes::loop_runs, "a loop holds nothing and nothing holds it: it will run",
       "knit it, or keep it on its needle", say);
  warn(graph, floats(graph), codes::long_float, fmt::format("yarn floats past more than {} needles", longest_float),
       "tuck it on the way", say);
}

}  // namespace wale::passes
