#include "sim/mid_surface.hpp"

#include <cmath>

namespace wale {
namespace {

/// Of one place: h = (1 - ρ) / κ with its distance ρ / κ from the axis, and its slopes.
struct Height {
  Height(const Vec3& place, const Cylinder& on) {
    const double curvature = on.curvature, y = place[on.around], z = place.z(),
                 from_axis = std::hypot(1 - curvature * z, curvature * y);
    const double squared = y * y + z * z, rise = 2 * z - curvature * squared;
    value = rise / (1 + from_axis);
    by_place[on.around] = -curvature * y / from_axis;
    by_place.z() = (1 - curvature * z) / from_axis;
    const double from_axis_by_curvature = (curvature * squared - z) / from_axis;
    by_curvature = -(squared * (1 + from_axis) + rise * from_axis_by_curvature) / std::pow(1 + from_axis, 2);
  }
  double value = 0;  // m
  Vec3 by_place = Vec3::Zero();
  double by_curvature = 0;  // m²
};

}  // namespace

MidSurface::MidSurface(const PeriodicCell& cell, Eigen::VectorXd weights) : cell_(cell), weights_(std::move(weights)) {
  weights_.tail<2>().setZero();
  weights_ /= weights_.sum();
}

double MidSurface::height(const Points& q) const {
  const Cylinder on = cylinder(cell_, q.rightCols<2>());
  double mean = 0;
  for (Eigen::Index k = 0; k + 2 < q.cols(); ++k) mean += weights_[k] * Height(q.col(k), on).value;
  return mean;
}

Points MidSurface::slope(const Points& q) const {
  const Cylinder on = cylinder(cell_, q.rightCols<2>());
  Points by = Points::Zero(3, q.cols());
  for (Eigen::Index k = 0; k + 2 < q.cols(); ++k) {
    const Height at(q.col(k), on);
    by.col(k) = weights_[k] * at.by_place;
    by(2, q.cols() - 1) += weights_[k] * at.by_curvature / curl_unit(cell_);
  }
  return by;
}

void MidSurface::settle(Points& q) const {
  const Cylinder on = cylinder(cell_, q.rightCols<2>());
  Points flat = rolled_out(cell_, q);
  flat.row(2).array() -= height(q);
  for (Eigen::Index k = 0; k + 2 < q.cols(); ++k) q.col(k) = rolled_up(flat.col(k), on);
}

}  // namespace wale
