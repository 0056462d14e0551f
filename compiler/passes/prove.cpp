#include <fmt/format.h>

#include <algorithm>

#include "compiler/passes.hpp"
#include "compiler/passes/entanglements.hpp"
#include "compiler/passes/program_codes.hpp"
#include "sim/clasps.hpp"

namespace wale::passes {
namespace {

/// As the viewer sees it. What lies flat shows all its crossings at once; only where it does not is there a need to
/// look from all sides.
std::vector<Crossing> unclear_from_the_face(const Fabric& fabric, const std::vector<Crossing>& crossings) {
  std::vector<char> clear(crossings.size(), 0);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < crossings.size(); ++i)
    clear[i] = crosses_twice(fabric, crossings[i], fabric.points, Vec3::UnitZ());
  std::vector<Crossing> unclear;
  for (std::size_t i = 0; i < crossings.size(); ++i)
    if (!clear[i]) unclear.push_back(crossings[i]);
  return unclear;
}

constexpr std::string_view leave_out =
    "`wale check` still counts this program; --courses and --needles (in a scene: crop) leave a part of it out";

void prove_nothing_else(const StitchGraph& graph, const Fabric& fabric, Diagnostics& say) {
  const std::vector<Entanglement> found = entanglements(graph, fabric);
  if (found.empty()) return;
  const Entanglement& first = found.front();
  say.error(
      codes::entangled, graph.loops[static_cast<std::size_t>(first.loop)].span,
      fmt::format("loop {} or the yarn that leads to it is drawn through loop {}, which it does not touch ({} such "
                  "places)",
                  first.loop, first.with, found.size()),
      std::string(leave_out));
}

}  // namespace

void prove_crossings(const StitchGraph& graph, const Fabric& fabric, const std::vector<Crossing>& crossings,
                     Diagnostics& say) {
  const std::vector<Crossing> unclear = unclear_from_the_face(fabric, crossings);
  const std::vector<bool> held = Clasps(fabric, unclear).follow(fabric.points);
  const auto wrong = std::find(held.begin(), held.end(), false);
  if (wrong == held.end()) return;
  const Crossing& at = unclear[static_cast<std::size_t>(wrong - held.begin())];
  const int loop = fabric.segment(at.loop_first).stitch;
  say.error(codes::not_placeable, graph.loops[static_cast<std::size_t>(loop)].span,
            fmt::format("loop {} cannot be placed yet so that what is knit through it is drawn through it ({} of {} "
                        "crossings are wrong)",
                        loop, std::count(held.begin(), held.end(), false), crossings.size()),
            std::string(leave_out));
}

void prove(const StitchGraph& graph, const Fabric& fabric, const std::vector<Crossing>& crossings, Diagnostics& say) {
  prove_crossings(graph, fabric, crossings, say);
  prove_nothing_else(graph, fabric, say);
}

}  // namespace wale::passes
