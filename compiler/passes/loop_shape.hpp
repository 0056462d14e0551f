/// The shape of one loop in a row, before tightening: Ding et al. 2023, Eq. (4), with depth by the over/under rule.
#pragma once

#include "compiler/passes/smooth_step.hpp"
#include "sim/fabric.hpp"

namespace wale {

/// Sizes of the loose loops that a fabric is first drawn with, m.
struct LoopSize {
  double x = 0;      ///< λx: wales are 4 λx apart, a head is 3 λx wide
  double y = 0;      ///< λy: a loop is 2 λy high
  double z = 0;      ///< λz: a yarn leaves the middle plane by so much
  double pitch = 0;  ///< from one course to the next
  double wale() const { return 4 * x; }
};

/// Loops round a yarn of contact diameter `diameter` whose axes keep 0.8 diameters apart, whatever the stitches (jersey
/// keeps 0.9), once drawn with twelve segments a stitch; 0.7 where a tube is bound off. `enlarge` >= 1 scales them in
/// the plane.
LoopSize loose_loops(double diameter, double enlarge);

/// Signs of a loop: its own, s, and that of the loop pulled through it, S; +1 is knit, -1 purl, seen from the face.
struct LoopSigns {
  int own = 1, above = 1;
};

struct Curve3 {
  Vec3 y, dy;  ///< position and derivative by w
};

/// A loop of a row whose neighbours have the signs given; w in [-2, 2], head at w = 0, feet at w = ±2.
/// Its head and its right foot's sinker follow the rule: from head to sinker the loop meets the loop above with
/// depth -S (head), +S (upper leg), and the loop below with +s (lower leg), -s (sinker). Centre of the head at x = 0.
Curve3 loop_point(const LoopSize&, const LoopSigns& left, const LoopSigns& here, const LoopSigns& right, double w);

/// Share of the right-hand stitch in a sinker, by distance in w from its middle.
Smooth share_of_right(double from_middle);

/// Loose loops long enough for stitches of up to `longest_stitch`, m: rest lengths only shrink afterwards.
LoopSize large_enough(double diameter, double longest_stitch);

}  // namespace wale
