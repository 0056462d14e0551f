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

}  // namespace wale
