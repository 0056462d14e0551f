/// Whether a state still has every crossing that the stitch graph demands.
#pragma once

#include "sim/results/results.hpp"

namespace wale {

/// Counts the demanded crossings that a state has: over all directions of view, the side of a loop crosses the loop that
/// it was pulled through twice, both times with `Crossing::sign`, rather than not at all. It may be asked in any pose.
Topology check_crossings(const Fabric&, const std::vector<Crossing>&, const Points& q);

/// The state with fewer crossings found: how the topology of a whole run is gathered. A count of none demanded
/// gives way to the other.
Topology worse(const Topology&, const Topology&);

}  // namespace wale
