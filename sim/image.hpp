/// Where a periodic fabric that may curl comes again, some periods on.
#pragma once

#include <complex>

#include "sim/fabric.hpp"

namespace wale {

/// The last two columns of State::q: course period, wale period. Of a fabric that curls they lie in its mid-surface
/// rolled out flat, which passes through z = 0; z of the wale period is its curvature times curl_unit().
using Periods = Eigen::Matrix<double, 3, 2>;

/// m², the square of the period that is bent, as laid: so the force on z of the wale period compares with those on
/// yarn.
double curl_unit(const PeriodicCell&);
/// 1/m, above 0 if the axis lies on the side of z > 0.
double curvature(const PeriodicCell&, const Periods&);
/// The coordinate that goes around the axis: 0, x, or 1, y.
int around(const PeriodicCell&);

/// An image of the repeat, so many course and wale periods on, in a fabric that curls about an axis at z = 1/κ: with D
/// the sum of so many periods in the mid-surface rolled out flat, and its parts D_a along the axis and D_u around it, y
/// goes to
///   X(y) = R y + t,  R a turn by κ D_u about the axis,  t_a = D_a, t_u = sin(κ D_u) / κ, t_z = (1 - cos(κ D_u)) / κ,
/// which is y + D where κ = 0. Images of images are images: the turns about one axis commute.
class Image {
 public:
  Image(const PeriodicCell&, const Periods&, const Eigen::Vector2i& steps);

  Vec3 operator()(const Vec3& y) const { return turn_ * y + shift_; }
  /// The place of which this is the image.
  Vec3 back(const Vec3& x) const { return turn_.transpose() * (x - shift_); }
  /// R = ∂X/∂y.
  const Mat3& turn() const { return turn_; }
  /// ∂X/∂(period).
  Mat3 by_period(const Vec3& y, int period) const;
  /// Derivative of f·∂X/∂y (rows) by a period (columns), for a constant f.
  Mat3 mixed(const Vec3& f, int period) const;
  /// Derivative of f·X by two periods, for a constant f.
  Mat3 by_periods(const Vec3& f, const Vec3& y, int first, int second) const;

 private:
  using Complex = std::complex<double>;  // a place in the plane across the axis: y_u + i z
  Complex plane(const Vec3& y) const { return {y[around_], y.z()}; }
  Vec3 in_space(const Complex& p) const;

  int around_ = 1;
  Eigen::Vector2d steps_;
  double unit_ = 0;                     // κ of a metre of the wale period's z, 1/m²
  double curvature_ = 0, further_ = 0;  // κ and D_u
  Complex turned_;                      // exp(iκ D_u)
  std::array<Complex, 3> arc_;          // see arc()
  Mat3 turn_ = Mat3::Identity();
  Vec3 shift_;
};

/// Of forces on the images of four control points, N, what the points themselves bear and the periods, which move their
/// images; `points` are these four, m.
struct OnImage {
  Eigen::Matrix<double, 3, 4> points;
  Periods periods;
};
OnImage carried_back(const Image&, const Eigen::Matrix<double, 3, 4>& points,
                     const Eigen::Matrix<double, 3, 4>& forces);

/// A cylinder that a flat fabric is rolled up to: its curvature, 1/m, and the coordinate around its axis.
struct Cylinder {
  double curvature = 0;
  int around = 1;
};
Cylinder cylinder(const PeriodicCell&, const Periods&);

/// A place beside a cylinder, rolled out flat: its arc along the mid-surface in place of the coordinate around, and its
/// height over it in place of z, m. Takes places that are less than half a turn from `middle`, the angle of another,
/// rad.
Vec3 rolled_out(const Vec3& place, const Cylinder&, double middle = 0);
/// The other way about. The height must lie on this side of the axis.
Vec3 rolled_up(const Vec3& flat, const Cylinder&);
/// The angle about the axis of the middle of some places, rad.
double middle_angle(const Points& places, const Cylinder&);

/// All control points of a State::q rolled out, and its periods flat. They must be less than one turn.
Points rolled_out(const PeriodicCell&, const Points& q);

}  // namespace wale
