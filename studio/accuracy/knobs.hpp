/// What in a scene trades accuracy for time, and the values that a study gives it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/front/scene.hpp"
#include "studio/accuracy/variant.hpp"

namespace wale {

/// One value of a knob.
struct Rung {
  std::string label;  ///< "24", "3 %"
  double size = 0;    ///< falls to 0 as the answer becomes exact: the length of a segment, a tolerance
  Variant variant{};
  bool as_written = false;  ///< the scene as its file says
};

struct Knob {
  enum class Kind : std::uint8_t {
    resolution,  ///< the error falls to nothing with the size
    choice       ///< other models or methods: none is the limit of the others
  };
  std::string key;   ///< as the command line calls it: "segments"
  std::string noun;  ///< in sentences: "segments a stitch"
  Kind kind = Kind::resolution;
  std::optional<double> order{};  ///< by which the error is expected to fall with the size
  std::vector<Rung> rungs{};      ///< from coarse to fine; one of them as written
  bool by_request = false;        ///< costs so much that it is only tried when asked for
  bool finds_rest = false;        ///< its error is that of the rest itself, which each run is to find by itself
};

/// The knobs that a scene has. `parsed` and `compiled` are that scene, `of_chart` says whether its pattern is one.
std::vector<Knob> knobs_of(const ParsedScene& parsed, const Scene& compiled, bool of_chart);

/// Every knob of resolution at once, from coarse to fine; the last two are the references of a study.
Knob all_together(const ParsedScene& parsed);

}  // namespace wale
