#include "sim/net_crossing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace wale {
namespace {

/// The points with x, y across the view and z towards the viewer.
Points turned(const Points& points, const Vec3& along) {
  return Eigen::Quaterniond::FromTwoVectors(along, Vec3::UnitZ()).toRotationMatrix() * points;
}

double cross(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

struct Crossed {
  bool left = false;         // the second comes from the right and goes to the left
  bool first_above = false;  // nearer to the viewer
};

/// Where the pieces a b and c d cross, if they do. Half-open at the second ends, so that a crossing at a corner counts
/// once.
std::optional<Crossed> crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = d - c, w = c - a;
  const double turn = cross(u.x(), u.y(), v.x(), v.y());
  if (turn == 0) return {};
  const double s = cross(w.x(), w.y(), v.x(), v.y()) / turn, t = cross(w.x(), w.y(), u.x(), u.y()) / turn;
  if (s < 0 || s >= 1 || t < 0 || t >= 1) return {};
  return Crossed{turn > 0, a.z() + s * u.z() > c.z() + t * v.z()};
}

/// Whether what lies between `low` and `high` lies beside what lies between the others, as the viewer sees them.
bool apart(const Vec3& low, const Vec3& high, const Vec3& other_low, const Vec3& other_high) {
  return high.x() < other_low.x() || low.x() > other_high.x() || high.y() < other_low.y() || low.y() > other_high.y();
}

template <class Visit>
void for_each_crossing(const Points& a, const Points& b, const Vec3& along, const Visit& visit) {
  const Points p = turned(a, along), q = turned(b, along);
  const Vec3 low = q.rowwise().minCoeff(), high = q.rowwise().maxCoeff();
  const Eigen::Index pieces = q.cols() - 1;
  const Points lows = q.leftCols(pieces).cwiseMin(q.rightCols(pieces)),
               highs = q.leftCols(pieces).cwiseMax(q.rightCols(pieces));
  for (Eigen::Index i = 1; i < p.cols(); ++i) {
    const Vec3 from = p.col(i - 1), to = p.col(i), near = from.cwiseMin(to), far = from.cwiseMax(to);
    if (apart(near, far, low, high)) continue;
    for (Eigen::Index j = 0; j < pieces; ++j) {
      if (apart(near, far, lows.col(j), highs.col(j))) continue;
      if (const auto at = crossing(from, to, q.col(j), q.col(j + 1))) visit(*at);
    }
  }
}

constexpr int view_count = 24;

/// Directions spread evenly over the sphere, along a spiral from pole to pole.
std::array<Vec3, view_count> spread_views() {
  std::array<Vec3, view_count> views;
  for (int i = 0; i < view_count; ++i) {
    const double z = 1 - (2 * i + 1.0) / view_count, angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    views[static_cast<std::size_t>(i)] = {std::sqrt(1 - z * z) * std::cos(angle),
                                          std::sqrt(1 - z * z) * std::sin(angle), z};
  }
  return views;
}

}  // namespace

int net_crossing(const Points& a, const Points& b, const Vec3& along) {
  int sum = 0;
  for_each_crossing(a, b, along, [&sum](const Crossed& at) { sum += at.left == at.first_above ? 1 : -1; });
  return sum;
}

double mean_net_crossing(const Points& a, const Points& b) {
  static const std::array<Vec3, view_count> views = spread_views();
  int sum = 0;
  for (const Vec3& view : views) sum += net_crossing(a, b, view);
  return static_cast<double>(sum) / view_count;
}

Passing passing(const Points& a, const Points& b, const Vec3& along) {
  Passing seen;
  for_each_crossing(a, b, along, [&seen](const Crossed& at) { ++(at.first_above ? seen.before : seen.behind); });
  return seen;
}

Vec3 area_vector(const Points& loop) {
  Vec3 area = Vec3::Zero();
  for (Eigen::Index i = 0; i < loop.cols(); ++i) {
    const Vec3 a = loop.col(i), b = loop.col((i + 1) % loop.cols());
    area += a.cross(b) / 2;
  }
  return area;
}

}  // namespace wale
