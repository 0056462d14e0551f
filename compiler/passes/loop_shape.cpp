#include "compiler/passes/loop_shape.hpp"

#include <cmath>
#include <numbers>

#include "compiler/passes/smooth_step.hpp"

namespace wale {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double blend_width = 0.4;  // in w, on either side of the middle of a sinker; see ArcLength for its steps
constexpr double tightest = 0.98;    // a stitch drawn is at least so much longer than the stitch asked for
constexpr double phase_shift = 0.2;  // in half waves, towards the leg's middle

/// Of πw, which is the same again a wale, or four in w, further on.
struct Turn {
  double sine = 0, cosine = 1;
};

/// Where the loop above has the same sign, the paper's form; where not, three half waves instead of two from head to
/// sinker, so that all four depths still follow the rule. They are shorter about the leg's middle, where nothing
/// crosses, for the sake of head and sinker. In λz, slope by w.
Smooth own_depth(const LoopSigns& signs, double w, const Turn& turn) {
  if (signs.own == signs.above) return {-signs.above * turn.cosine, signs.above * pi * turn.sine};
  const Smooth phase{1.5 * w - phase_shift * turn.sine, 1.5 - phase_shift * pi * turn.cosine};
  return {-signs.above * std::cos(pi * phase.value), signs.above * pi * phase.slope * std::sin(pi * phase.value)};
}

Smooth mix(const Smooth& a, const Smooth& b, const Smooth& share) {
  return {a.value + share.value * (b.value - a.value),
          a.slope + share.value * (b.slope - a.slope) + share.slope * (b.value - a.value)};
}

Smooth loop_depth(const LoopSigns& left, const LoopSigns& here, const LoopSigns& right, double w, const Turn& turn) {
  const Smooth share = share_of_right(w > 0 ? w - 2 : w + 2);
  const auto own = [&turn](const LoopSigns& signs, double at) { return own_depth(signs, at, turn); };
  if (w > 0) return share.value == 0 ? own(here, w) : mix(own(here, w), own(right, w - 4), share);
  return share.value == 1 ? own(here, w) : mix(own(left, w + 4), own(here, w), share);
}

double jersey_length(const LoopSize& size) {
  constexpr int steps = 400;
  double length = 0;
  for (int i = 0; i < steps; ++i)
    length += loop_point(size, {}, {}, {}, -2 + 4 * (i + 0.5) / steps).dy.norm() * 4 / steps;
  return length;
}

}  // namespace

Smooth share_of_right(double from_middle) {
  Smooth share = smooth_step((from_middle + blend_width) / (2 * blend_width));
  share.slope /= 2 * blend_width;
  return share;
}

LoopSize loose_loops(double diameter, double enlarge) {
  return {1.25 * diameter * enlarge, 2.7 * diameter * enlarge, 0.88 * diameter, 3.5 * diameter * enlarge};
}

Curve3 loop_point(const LoopSize& size, const LoopSigns& left, const LoopSigns& here, const LoopSigns& right,
                  double w) {
  const double sine = std::sin(pi * w / 2), cosine = std::cos(pi * w / 2);
  const Turn turn{2 * sine * cosine, cosine * cosine - sine * sine};
  const Smooth depth = loop_depth(left, here, right, w, turn);
  return {{size.x * (w + turn.sine), size.y * cosine, size.z * depth.value},
          {size.x * (1 + pi * turn.cosine), -size.y * pi / 2 * sine, size.z * depth.slope}};
}

/// Depth does not grow, so length grows a little less than size.
LoopSize large_enough(double diameter, double longest_stitch) {
  double enlarge = 1;
  for (int k = 0; k < 20; ++k)
    enlarge = std::max(1.0, enlarge * longest_stitch / (tightest * jersey_length(loose_loops(diameter, enlarge))));
  return loose_loops(diameter, enlarge);
}

}  // namespace wale
