/// Whether a state still has every crossing that the stitch graph demands.
#pragma once

#include "sim/results/results.hpp"

namespace wale {

/// Counts the crossings whose leg passes net `Crossing::sign` times through its loop, as signed_passes() counts:
/// +1 along the area vector of the loop taken from loop_first to loop_last.
Topology check_crossings(const Fabric&, const std::vector<Crossing>&, const Points& q);

/// The state with fewer crossings found: how the topology of a whole run is gathered. A count of none demanded
/// gives way to the other.
Topology worse(const Topology&, const Topology&);

}  // namespace wale
