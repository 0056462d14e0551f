#include "compiler/layout.hpp"

#include <fmt/format.h>

#include <iterator>

namespace wale {
namespace {

const char* face(int sign) { return sign > 0 ? "knit" : "purl"; }

}  // namespace

std::string print(const Layout& layout) {
  std::string text = fmt::format("{} of {} wales x {} courses, {}, {}\n", layout.form == Form::flat ? "flat" : "tube",
                                 layout.wales, layout.courses, layout.cast_on ? "cast on" : "open start",
                                 layout.bind_off ? "bound off" : "open end");
  const auto out = std::back_inserter(text);
  for (std::size_t course = 0; course < layout.rows.size(); ++course) {
    fmt::format_to(out, "course {} from the {}\n", course + 1, layout.from_left[course] ? "left" : "right");
    for (const PlacedLoop& at : layout.rows[course])
      fmt::format_to(out, "  wale {}: loop {} {}, above it {}, yarn {}, {:.4g} mm\n", at.wale + 1, at.loop,
                     face(at.sign), face(at.sign_above), at.material, at.stitch_length * 1e3);
  }
  return text;
}

}  // namespace wale
