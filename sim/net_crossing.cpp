#include "sim/net_crossing.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace wale {
namespace {

/// The points with x, y across the view and z towards the viewer.
Points turned(const Points& points, const Vec3& along) {
  return Eigen::Quaterniond::FromTwoVectors(along, Vec3::UnitZ()).toRotationMatrix() * points;
}

double cross(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

/// The sign of the crossing of the pieces a b and c d, 0 if they do not cross. Half-open at the second ends, so that a
/// crossing at a corner counts once.
int crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = d - c, w = c - a;
  const double turn = cross(u.x(), u.y(), v.x(), v.y());
  if (turn == 0) return 0;
  const double s = cross(w.x(), w.y(), v.x(), v.y()) / turn, t = cross(w.x(), w.y(), u.x(), u.y()) / turn;
  if (s < 0 || s >= 1 || t < 0 || t >= 1) return 0;
  const bool first_above = a.z() + s * u.z() > c.z() + t * v.z();
  return (turn > 0) == first_above ? 1 : -1;
}

bool apart(const Vec3& a, const Vec3& b, double low_x, double high_x, double low_y, double high_y) {
  return std::max(a.x(), b.x()) < low_x || std::min(a.x(), b.x()) > high_x || std::max(a.y(), b.y()) < low_y ||
         std::min(a.y(), b.y()) > high_y;
}

}  // namespace

int net_crossing(const Points& a, const Points& b, const Vec3& along) {
  const Points p = turned(a, along), q = turned(b, along);
  const Vec3 low = q.rowwise().minCoeff(), high = q.rowwise().maxCoeff();
  int sum = 0;
  for (Eigen::Index i = 1; i < p.cols(); ++i) {
    const Vec3 from = p.col(i - 1), to = p.col(i);
    if (apart(from, to, low.x(), high.x(), low.y(), high.y())) continue;
    for (Eigen::Index j = 1; j < q.cols(); ++j) sum += crossing(from, to, q.col(j - 1), q.col(j));
  }
  return sum;
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
