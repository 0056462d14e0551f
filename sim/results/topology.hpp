/// Whether a state still has every crossing that the stitch graph demands.
#pragma once

#include <vector>

#include "sim/results/results.hpp"

namespace wale {

/// How many clasps hold.
Topology tally(const std::vector<bool>& held);

/// The crossings of one state that is near to what the compiler laid.
Topology check_crossings(const Fabric&, const std::vector<Crossing>&, const Points& q);

/// The state with fewer crossings found: how the topology of a whole run is gathered. A count of none demanded
/// gives way to the other.
Topology worse(const Topology&, const Topology&);

}  // namespace wale
