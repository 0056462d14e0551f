/// Whether a yarn passes through a loop, and from which side: an intersection number, so it holds in any pose.
#pragma once

#include "sim/fabric.hpp"

namespace wale {

/// How often the polyline `leg` (3 x n, m) passes through the surface that `loop` (3 x m, closed by the chord from
/// its last point to its first) spans, net. Passing along the loop's area vector ½ Σ a x b counts +1, against it -1.
/// The surface is the fan of triangles from the mean of the loop's points. Every test is half-open in the same way
/// for neighbours, so a leg through an edge or a corner counts once.
int signed_passes(const Points& leg, const Points& loop);

/// The same for the spline over segments [leg_first, leg_last] and [loop_first, loop_last], six points a segment.
/// Throws std::invalid_argument if a range is not one of segments of one yarn.
int signed_passes(const Fabric&, const Points& q, int leg_first, int leg_last, int loop_first, int loop_last);

}  // namespace wale
