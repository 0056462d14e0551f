#include "sim/results/topology.hpp"

#include <Eigen/Geometry>
#include <array>

#include "sim/net_crossing.hpp"
#include "sim/polyline.hpp"

namespace wale {

namespace {

/// Straight at the loop, and from four sides of that: where a head hides behind another in one view, it does not in all.
std::array<Vec3, 5> views(const Vec3& facing) {
  const Vec3 straight = facing.normalized(), aside = straight.unitOrthogonal(), up = straight.cross(aside);
  constexpr double tilt = 0.5;
  return {straight, straight + tilt * aside, straight - tilt * aside, straight + tilt * up, straight - tilt * up};
}

/// A side that has been torn out of its loop does not cross it so from anywhere.
bool holds(const Points& side, const Points& loop, int sign) {
  for (const Vec3& view : views(area_vector(loop)))
    if (net_crossing(side, loop, view) == 2 * sign) return true;
  return false;
}

}  // namespace

Topology check_crossings(const Fabric& fabric, const std::vector<Crossing>& crossings, const Points& q) {
  constexpr int per_segment = 6;
  Topology topology{static_cast<long>(crossings.size()), 0};
  for (const Crossing& at : crossings) {
    const Points loop = polyline(fabric, q, at.loop_first, at.loop_last, per_segment);
    const Points side = polyline(fabric, q, at.side_first, at.side_last, per_segment);
    if (holds(side, loop, at.sign)) ++topology.found;
  }
  return topology;
}

Topology worse(const Topology& a, const Topology& b) {
  if (a.expected == 0) return b;
  if (b.expected == 0) return a;
  return b.found < a.found ? b : a;
}

}  // namespace wale
