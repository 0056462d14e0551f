#include "tests/stability/linking.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace wale::stability {
namespace {

/// The signed solid angle of a triangle seen from the origin (van Oosterom & Strackee 1983).
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double r = a.norm(), s = b.norm(), t = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), r * s * t + a.dot(b) * t + b.dot(c) * r + c.dot(a) * s);
}

}  // namespace

double linking_number(const Points& a, const Points& b) {
  double sum = 0;
  for (Eigen::Index i = 0; i < a.cols(); ++i) {
    const Vec3 from = a.col(i), to = a.col((i + 1) % a.cols());
    for (Eigen::Index j = 0; j < b.cols(); ++j) {
      const Vec3 c = b.col(j), d = b.col((j + 1) % b.cols());
      // All differences of a point of one piece and a point of the other: a quadrangle on the sphere.
      sum += solid_angle(c - from, c - to, d - to) + solid_angle(d - to, d - from, c - from);
    }
  }
  return sum / (4 * std::numbers::pi);
}

}  // namespace wale::stability
