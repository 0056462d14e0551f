#include "compiler/arrangement.hpp"

#include <fmt/format.h>

#include <iterator>

namespace wale {

std::string print(const Arrangement& of) {
  std::string text;
  for (std::size_t i = 0; i < of.loops.size(); ++i) {
    const Hanging& loop = of.loops[i];
    const Vec3 feet = 1e3 * of.anchors[static_cast<std::size_t>(loop.feet)].at;
    const Vec3 head = 1e3 * of.anchors[static_cast<std::size_t>(loop.head)].at;
    fmt::format_to(std::back_inserter(text), "loop {}: {} {} feet {:.2f} {:.2f} {:.2f} head {:.2f} {:.2f} {:.2f} mm\n",
                   i, loop.sign > 0 ? "knit" : "purl", loop.heading > 0 ? "+" : "-", feet.x(), feet.y(), feet.z(),
                   head.x(), head.y(), head.z());
  }
  return text;
}

}  // namespace wale
