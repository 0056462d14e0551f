#include "sim/turns.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/spline.hpp"

namespace wale {

Turns turns_about(const Fabric& fabric, const Points& q, const Vec3& axis) {
  const Vec3 centre = (q.rowwise().minCoeff() + q.rowwise().maxCoeff()) / 2;
  Turns found;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Yarn& yarn : fabric.yarns) {
    Vec3 before = Vec3::Zero();
    for (int i = 0; i < yarn.segments; ++i) {
      const Vec3 at = combine(q, yarn.first_point + i, basis(0.5).value) - centre;
      least = std::min(least, axis.dot(at));
      most = std::max(most, axis.dot(at));
      const Vec3 around = at - axis.dot(at) * axis;
      if (i > 0) found.count += std::atan2(axis.dot(before.cross(around)), before.dot(around)) / (2 * std::numbers::pi);
      before = around;
    }
  }
  found.extent = std::max(most - least, 0.0);
  return found;
}

}  // namespace wale
