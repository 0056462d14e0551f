/// What pictures and frames show of a state.
#pragma once

#include "sim/scene.hpp"

namespace wale {

/// The fabric with its control points at `q`, m. Of a periodic one, whose `q` ends with its two periods, so many
/// repeats side by side that there are at least six stitches each way.
Fabric shown_fabric(const Fabric&, const Gauge&, const Points& q);

/// Control points as one sees them who looks along the axis of a cylinder that a fabric of `curls` is bent to: with the
/// face to the right of a fabric that stands upright, or above one that lies; m.
Points seen_along_axis(Curls curls, const Points& shown);

}  // namespace wale
