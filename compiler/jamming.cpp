#include "compiler/jamming.hpp"

#include <fmt/format.h>

#include "compiler/front/limits.hpp"

namespace wale {

bool jams(double stitch_length, const Material& yarn) { return stitch_length < limits::jamming_ratio * yarn.diameter; }

void warn_of_jamming(double stitch_length, const Material& yarn, std::string_view name, Span place, Diagnostics& say) {
  say.warning(
      "C020", place,
      fmt::format("yarn \"{}\" is too thick for its stitches: stitch length / contact diameter = {:.2f}", name,
                  stitch_length / yarn.diameter),
      fmt::format("a jersey of hard tubes jams at l/d = {}; lengthen the stitch to {:.2f} mm, or take a thinner yarn",
                  limits::jamming_ratio, limits::jamming_ratio * yarn.diameter * 1e3));
}

void warn_of_jamming(const StitchGraph& graph, const std::vector<Material>& yarns, Diagnostics& say) {
  std::vector<const Loop*> shortest(yarns.size(), nullptr);
  for (const Loop& loop : graph.loops) {
    const Loop*& of_carrier = shortest[static_cast<std::size_t>(loop.carrier)];
    if (loop.stitch_length > 0 && (!of_carrier || loop.stitch_length < of_carrier->stitch_length)) of_carrier = &loop;
  }
  for (std::size_t i = 0; i < yarns.size(); ++i)
    if (shortest[i] && jams(shortest[i]->stitch_length, yarns[i]))
      warn_of_jamming(shortest[i]->stitch_length, yarns[i], yarns[i].name, shortest[i]->span, say);
}

}  // namespace wale
