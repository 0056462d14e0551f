#include "sim/pass_through.hpp"

#include <Eigen/Geometry>

#include "sim/polyline.hpp"

namespace wale {
namespace {

double triple(const Vec3& a, const Vec3& b, const Vec3& c) { return a.dot(b.cross(c)); }

/// Whether the line of direction `along` through `from` meets the triangle (centre, a, b), given that the piece
/// crosses its plane. Both triangles at a spoke (centre, a) evaluate the same expression for it.
bool meets(const Vec3& from, const Vec3& along, const Vec3& centre, const Vec3& a, const Vec3& b) {
  const Vec3 to_centre = centre - from, to_a = a - from, to_b = b - from;
  const bool spoke_in = triple(along, to_centre, to_a) >= 0;
  const bool spoke_out = triple(along, to_centre, to_b) >= 0;
  const bool rim = triple(along, to_a, to_b) >= 0;
  return spoke_in != spoke_out && spoke_in == rim;
}

/// Passes of the leg through one triangle.
int passes(const Points& leg, const Vec3& centre, const Vec3& a, const Vec3& b) {
  const Vec3 normal = (a - centre).cross(b - centre);
  const auto is_above = [&](Eigen::Index i) { return normal.dot(leg.col(i) - centre) >= 0; };
  int count = 0;
  bool above = is_above(0);
  for (Eigen::Index i = 1; i < leg.cols(); ++i) {
    const bool was_above = above;
    above = is_above(i);
    if (above != was_above && meets(leg.col(i - 1), leg.col(i) - leg.col(i - 1), centre, a, b)) count += above ? 1 : -1;
  }
  return count;
}

}  // namespace

int signed_passes(const Points& leg, const Points& loop) {
  if (leg.cols() < 2 || loop.cols() < 3) return 0;
  const Vec3 leg_low = leg.rowwise().minCoeff(), leg_high = leg.rowwise().maxCoeff();
  const Vec3 loop_low = loop.rowwise().minCoeff(), loop_high = loop.rowwise().maxCoeff();
  if ((leg_low.array() > loop_high.array()).any() || (leg_high.array() < loop_low.array()).any()) return 0;
  const Vec3 centre = loop.rowwise().mean();
  int count = 0;
  for (Eigen::Index i = 0; i < loop.cols(); ++i)
    count += passes(leg, centre, loop.col(i), loop.col((i + 1) % loop.cols()));
  return count;
}

int signed_passes(const Fabric& fabric, const Points& q, int leg_first, int leg_last, int loop_first, int loop_last) {
  constexpr int per_segment = 6;
  return signed_passes(polyline(fabric, q, leg_first, leg_last, per_segment),
                       polyline(fabric, q, loop_first, loop_last, per_segment));
}

}  // namespace wale
