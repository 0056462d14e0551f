#include "compiler/passes/loop_shape.hpp"

#include <cmath>
#include <numbers>

#include "compiler/passes/smooth_step.hpp"

namespace wale {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double blend_width = 0.4;  // in w, on either side of the middle of a sinker; see ArcLength for its steps
constexpr double phase_shift = 0.2;  // in half waves, towards the leg's middle

/// Where the loop above has the same sign, the paper's form; where not, three half waves instead of two from head to
/// sinker, so that all four depths still follow the rule. They are shorter about the leg's middle, where nothing crosses,
/// for the sake of head and sinker. In λz, slope by w.
Smooth own_depth(const LoopSigns& signs, double w) {
  Smooth phase{w, 1};
  if (signs.own != signs.above)
    phase = {1.5 * w - phase_shift * std::sin(pi * w), 1.5 - phase_shift * pi * std::cos(pi * w)};
  return {-signs.above * std::cos(pi * phase.value), signs.above * pi * phase.slope * std::sin(pi * phase.value)};
}

Smooth mix(const Smooth& a, const Smooth& b, const Smooth& share) {
  return {a.value + share.value * (b.value - a.value),
          a.slope + share.value * (b.slope - a.slope) + share.slope * (b.value - a.value)};
}

/// Share of the right-hand stitch in a sinker, by distance from its middle.
Smooth share_of_right(double from_middle) {
  Smooth share = smooth_step((from_middle + blend_width) / (2 * blend_width));
  share.slope /= 2 * blend_width;
  return share;
}

Smooth loop_depth(const LoopSigns& left, const LoopSigns& here, const LoopSigns& right, double w) {
  if (w > 0) return mix(own_depth(here, w), own_depth(right, w - 4), share_of_right(w - 2));
  return mix(own_depth(left, w + 4), own_depth(here, w), share_of_right(w + 2));
}

}  // namespace

LoopSize loose_loops(double diameter, double enlarge) {
  return {1.25 * diameter * enlarge, 2.7 * diameter * enlarge, 0.88 * diameter, 3.5 * diameter * enlarge};
}

Curve3 loop_point(const LoopSize& size, const LoopSigns& left, const LoopSigns& here, const LoopSigns& right,
                  double w) {
  const Smooth depth = loop_depth(left, here, right, w);
  return {{size.x * (w + std::sin(pi * w)), size.y * std::cos(pi * w / 2), size.z * depth.value},
          {size.x * (1 + pi * std::cos(pi * w)), -size.y * pi / 2 * std::sin(pi * w / 2), size.z * depth.slope}};
}

}  // namespace wale
