/// A yarn bent to a circle.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "sim/spline.hpp"

namespace wale {

/// A full circle through `segments` + 1 even points, with the circle's tangents at both ends.
inline Points circle_points(double radius, int segments) {
  const Eigen::Index n = segments + 3;
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(n, n), right(n, 3);
  const Basis start = basis(0), end = basis(1);
  const double step = 2 * std::numbers::pi / segments;
  for (Eigen::Index i = 0; i <= segments; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) rows(i, i + k) = start.value[static_cast<std::size_t>(k)];
    const double angle = step * static_cast<double>(i);
    right.row(i) << radius * std::cos(angle), radius * std::sin(angle), 0;
  }
  for (Eigen::Index k = 0; k < 4; ++k) {
    rows(n - 2, k) = start.first[static_cast<std::size_t>(k)];
    rows(n - 1, n - 4 + k) = end.first[static_cast<std::size_t>(k)];
  }
  right.bottomRows(2) = Eigen::RowVector3d(0, radius * step, 0).replicate(2, 1);
  return rows.partialPivLu().solve(right).transpose();
}

}  // namespace wale
