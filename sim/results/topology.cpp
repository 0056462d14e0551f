#include "sim/results/topology.hpp"

#include <algorithm>

#include "sim/clasps.hpp"

namespace wale {

Topology tally(const std::vector<bool>& held) {
  return {static_cast<long>(held.size()), static_cast<long>(std::count(held.begin(), held.end(), true))};
}

Topology check_crossings(const Fabric& fabric, const std::vector<Crossing>& crossings, const Points& q) {
  return tally(Clasps(fabric, crossings).follow(q));
}

Topology worse(const Topology& a, const Topology& b) {
  if (a.expected == 0) return b;
  if (b.expected == 0) return a;
  return b.found < a.found ? b : a;
}

}  // namespace wale
