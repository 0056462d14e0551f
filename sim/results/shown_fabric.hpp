/// What pictures and frames show of a state.
#pragma once

#include "sim/scene.hpp"

namespace wale {

/// The fabric with its control points at `q`, m. Of a periodic one, whose `q` ends with its two periods, so many
/// repeats side by side that there are at least six stitches each way.
Fabric shown_fabric(const Fabric&, const Gauge&, const Points& q);

}  // namespace wale
