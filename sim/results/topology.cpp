#include "sim/results/topology.hpp"

#include "sim/pass_through.hpp"

namespace wale {

Topology check_crossings(const Fabric& fabric, const std::vector<Crossing>& crossings, const Points& q) {
  Topology topology{static_cast<long>(crossings.size()), 0};
  for (const Crossing& at : crossings)
    if (signed_passes(fabric, q, at.leg_first, at.leg_last, at.loop_first, at.loop_last) == at.sign) ++topology.found;
  return topology;
}

Topology worse(const Topology& a, const Topology& b) {
  if (a.expected == 0) return b;
  if (b.expected == 0) return a;
  return b.found < a.found ? b : a;
}

}  // namespace wale
