#include <fmt/format.h>

#include <algorithm>

#include "compiler/passes.hpp"
#include "compiler/passes/program_codes.hpp"
#include "sim/clasps.hpp"

namespace wale::passes {

void prove(const StitchGraph& graph, const Fabric& fabric, const std::vector<Crossing>& crossings, Diagnostics& say) {
  const std::vector<bool> held = Clasps(fabric, crossings).follow(fabric.points);
  const auto wrong = std::find(held.begin(), held.end(), false);
  if (wrong == held.end()) return;
  const Crossing& at = crossings[static_cast<std::size_t>(wrong - held.begin())];
  const int loop = fabric.segment(at.loop_first).stitch;
  say.error(codes::not_placeable, graph.loops[static_cast<std::size_t>(loop)].span,
            fmt::format("loop {} cannot be placed yet so that what is knit through it is drawn through it ({} of {} "
                        "crossings are wrong)",
                        loop, std::count(held.begin(), held.end(), false), held.size()),
            "`wale check` still counts this program; --courses and --needles leave a part of it out");
}

}  // namespace wale::passes
