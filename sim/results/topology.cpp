#include "sim/results/topology.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <tuple>

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

constexpr int per_segment = 4;         // points of a polyline
constexpr int surely = view_count;      // a count so high over all views is a crossing
constexpr int longest_look = 3;         // segments, to look past a count that stays equal

/// A demanded crossing in one state, looked for some way along the two yarns.
class Clasp {
 public:
  Clasp(const Fabric& fabric, const Crossing& at, const Points& q) : fabric_(fabric), at_(at), q_(q) {}

  /// Seen from anywhere, a side that is pulled through a loop crosses it twice in the same sense, unless an end of one lies
  /// in front of the other; the mean over all views, twice Gauss's linking integral of the two pieces, is near 2 for a
  /// clasp and near 0 for a side pushed out of its loop. Yarn slides through a pulled fabric: where the segments that the
  /// compiler named are no longer those that cross, the pieces are moved along their yarns while that raises the count.
  /// From a torn clasp there is no such way up to the next one, whose sense is the opposite.
  bool holds() const {
    int side = 0, loop = 0, count = crossings(0, 0);
    while (count < surely) {
      const auto better = step_up(side, loop, count);
      if (!better) return false;
      std::tie(side, loop, count) = *better;
    }
    return true;
  }

 private:
  using Found = std::tuple<int, int, int>;  // the shifts of side and loop, and the crossings there

  std::optional<Found> step_up(int side, int loop, int count) const {
    for (int step = 1; step <= longest_look; ++step)
      for (const auto& [by_side, by_loop] : {std::pair{step, 0}, {-step, 0}, {0, step}, {0, -step}}) {
        const int to_side = side + by_side, to_loop = loop + by_loop;
        if (!within_reach(to_side, at_.side_first, at_.side_last) || !within_reach(to_loop, at_.loop_first, at_.loop_last))
          continue;
        if (const int there = crossings(to_side, to_loop); there > count) return Found{to_side, to_loop, there};
      }
    return {};
  }

  /// No further than three quarters of the piece, and not past the ends of its yarn.
  bool within_reach(int shift, int first, int last) const {
    if (4 * std::abs(shift) > 3 * (last - first + 1)) return false;
    return first + shift >= 0 && last + shift < fabric_.segment_count() &&
           fabric_.segment(first + shift).yarn == fabric_.segment(last + shift).yarn;
  }

  int crossings(int side_shift, int loop_shift) const {
    static const std::array<Vec3, view_count> views = spread_views();
    const Points loop = polyline(fabric_, q_, at_.loop_first + loop_shift, at_.loop_last + loop_shift, per_segment);
    const Points side = polyline(fabric_, q_, at_.side_first + side_shift, at_.side_last + side_shift, per_segment);
    int sum = 0;
    for (const Vec3& view : views) sum += net_crossing(side, loop, view);
    return sum * at_.sign;
  }

  const Fabric& fabric_;
  const Crossing& at_;
  const Points& q_;
};

}  // namespace

Topology check_crossings(const Fabric& fabric, const std::vector<Crossing>& crossings, const Points& q) {
  Topology topology{static_cast<long>(crossings.size()), 0};
  for (const Crossing& at : crossings)
    if (Clasp(fabric, at, q).holds()) ++topology.found;
  return topology;
}

Topology worse(const Topology& a, const Topology& b) {
  if (a.expected == 0) return b;
  if (b.expected == 0) return a;
  return b.found < a.found ? b : a;
}

}  // namespace wale
