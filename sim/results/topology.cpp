#include "sim/results/topology.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "sim/net_crossing.hpp"
#include "sim/polyline.hpp"

namespace wale {

namespace {

constexpr int view_count = 24;

/// Directions spread evenly over the sphere, along a spiral from pole to pole.
std::array<Vec3, view_count> spread_views() {
  std::array<Vec3, view_count> views;
  for (int i = 0; i < view_count; ++i) {
    const double z = 1 - (2 * i + 1.0) / view_count, angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    views[static_cast<std::size_t>(i)] = {std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z};
  }
  return views;
}

/// Seen from anywhere, a side that is pulled through a loop crosses it twice in the same sense, unless an end of one
/// lies in front of the other; the mean over all views, twice Gauss's linking integral of the two pieces, is between 0
/// and 2. Pulled to 60 % it stays above 0.6; a side pushed out of its loop has less than 0.4.
bool holds(const Points& side, const Points& loop, int sign) {
  static const std::array<Vec3, view_count> views = spread_views();
  int sum = 0;
  for (const Vec3& view : views) sum += net_crossing(side, loop, view);
  return 5 * sum * sign > 2 * view_count;
}

}  // namespace

Topology check_crossings(const Fabric& fabric, const std::vector<Crossing>& crossings, const Points& q) {
  constexpr int per_segment = 4;
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
