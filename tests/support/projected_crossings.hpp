/// Every crossing of a fabric's yarn with itself, seen from the face; written without the simulator's own counting.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "sim/polyline.hpp"

namespace wale {

/// The yarn meets itself at two places along it, in segments; `first` < `second`.
struct SeenCrossing {
  double first = 0, second = 0;
  int above = 0;  ///< +1: the first is nearer to the viewer, -1: the second is
  int turn = 0;   ///< as a knot's crossing is counted: +1 or -1
};

/// A drawing of the yarn: x across, y up, z towards the viewer; `round` > 0 if x goes round with that period.
struct Drawn {
  Points points;
  int per_segment = 0;
  double round = 0;
};

/// A flat fabric as it is; a tube with its outside unrolled (x is an arc of the mean radius, z the distance outwards).
inline Drawn drawn_from_the_face(const Fabric& fabric, const Points& q, bool tube, int per_segment = 8) {
  Drawn drawn{polyline(fabric, q, 0, fabric.segment_count() - 1, per_segment), per_segment, 0};
  if (!tube) return drawn;
  const auto out = [](const auto& p) { return std::hypot(p.x(), p.z()); };
  double radius = 0;
  for (const auto& p : drawn.points.colwise()) radius += out(p) / static_cast<double>(drawn.points.cols());
  drawn.round = 2 * std::numbers::pi * radius;
  for (auto p : drawn.points.colwise()) p = Vec3(radius * std::atan2(p.x(), p.z()), p.y(), out(p));
  for (Eigen::Index k = 1; k < drawn.points.cols(); ++k) {
    const double step = drawn.points(0, k) - drawn.points(0, k - 1);
    drawn.points(0, k) -= drawn.round * std::round(step / drawn.round);
  }
  return drawn;
}

/// In the order of `first`.
inline std::vector<SeenCrossing> projected_crossings(const Drawn& drawn) {
  const Points& p = drawn.points;
  const auto pieces = static_cast<int>(p.cols()) - 1;
  const auto low = [&](int k) { return std::min(p(1, k), p(1, k + 1)); };
  const auto high = [&](int k) { return std::max(p(1, k), p(1, k + 1)); };
  std::vector<int> upwards(static_cast<std::size_t>(pieces));
  std::iota(upwards.begin(), upwards.end(), 0);
  std::sort(upwards.begin(), upwards.end(), [&](int a, int b) { return low(a) < low(b); });

  std::vector<SeenCrossing> seen;
  const auto meet = [&](int a, int b) {
    Vec3 shift = Vec3::Zero();
    if (drawn.round > 0) shift.x() = drawn.round * std::round((p(0, a) - p(0, b)) / drawn.round);
    const Vec3 u = p.col(a + 1) - p.col(a), v = p.col(b + 1) - p.col(b), w = p.col(b) + shift - p.col(a);
    const double turn = u.x() * v.y() - u.y() * v.x();
    const double s = (w.x() * v.y() - w.y() * v.x()) / turn, t = (w.x() * u.y() - w.y() * u.x()) / turn;
    if (!(s >= 0 && s < 1 && t >= 0 && t < 1)) return;
    const int above = s * u.z() > w.z() + t * v.z() ? 1 : -1;
    seen.push_back({(a + s) / drawn.per_segment, (b + t) / drawn.per_segment, above, turn > 0 ? above : -above});
  };
  for (std::size_t i = 0; i < upwards.size(); ++i)
    for (std::size_t j = i + 1; j < upwards.size() && low(upwards[j]) <= high(upwards[i]); ++j)
      if (std::abs(upwards[i] - upwards[j]) > 1)
        meet(std::min(upwards[i], upwards[j]), std::max(upwards[i], upwards[j]));
  std::sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return seen;
}

}  // namespace wale
