#include "sim/image.hpp"

#include <cmath>

namespace wale {
namespace {

using Complex = std::complex<double>;
constexpr Complex i{0, 1};

/// (exp(ix) - 1) / (ix) = sin x / x + i (1 - cos x) / x, and its first two derivatives by x.
std::array<Complex, 3> arc(double x) {
  std::array<Complex, 3> of{};
  if (std::abs(x) < 1) {
    // Σ (ix)ᵏ / (k + 1)!
    Complex term = 1;  // iᵏ / (k + 1)!
    for (int k = 0; k < 20; ++k, term *= i / static_cast<double>(k + 1)) {
      of[0] += term * std::pow(x, k);
      if (k > 0) of[1] += term * (k * std::pow(x, k - 1));
      if (k > 1) of[2] += term * (k * (k - 1) * std::pow(x, k - 2));
    }
    return of;
  }
  const Complex turned = std::polar(1.0, x);
  of[0] = (turned - 1.0) / (i * x);
  of[1] = (turned - of[0]) / x;
  of[2] = (i * turned - 2.0 * of[1]) / x;
  return of;
}

double dot(const Complex& a, const Complex& b) { return (std::conj(a) * b).real(); }

}  // namespace

int around(const PeriodicCell& cell) { return cell.curls == Curls::about_wales ? 0 : 1; }

double curl_unit(const PeriodicCell& cell) {
  const double bent = cell.curls == Curls::about_wales ? cell.course.x() : cell.wale.y();
  return bent * bent;
}

double curvature(const PeriodicCell& cell, const Periods& periods) { return periods(2, 1) / curl_unit(cell); }

Image::Image(const PeriodicCell& cell, const Periods& periods, const Eigen::Vector2i& steps)
    : around_(wale::around(cell)),
      steps_(steps.cast<double>()),
      unit_(1 / curl_unit(cell)),
      curvature_(wale::curvature(cell, periods)) {
  const Eigen::Vector2d flat = periods.topRows<2>() * steps_;
  further_ = flat[around_];
  turned_ = std::polar(1.0, curvature_ * further_);
  arc_ = arc(curvature_ * further_);
  turn_.col(around_) = in_space(turned_);
  turn_.col(2) = in_space(i * turned_);
  shift_ = in_space(further_ * arc_[0]);
  shift_[1 - around_] = flat[1 - around_];
}

Vec3 Image::in_space(const Complex& p) const {
  Vec3 place = Vec3::Zero();
  place[around_] = p.real();
  place.z() = p.imag();
  return place;
}

// In the plane across the axis X = exp(iκu) p + u arc(κu), with u = D_u, of which ∂X/∂u = exp(iκu) (1 + iκp).

Mat3 Image::by_period(const Vec3& y, int period) const {
  const Complex p = plane(y);
  Mat3 by = Mat3::Zero();
  by(1 - around_, 1 - around_) = steps_[period];
  by.col(around_) = steps_[period] * in_space(turned_ * (1.0 + i * curvature_ * p));
  if (period == 1) by.col(2) = unit_ * in_space(further_ * (i * turned_ * p + further_ * arc_[1]));
  return by;
}

Mat3 Image::mixed(const Vec3& f, int period) const {
  const Vec3 turned = in_space(std::conj(i * turned_) * plane(f));
  Mat3 by = Mat3::Zero();
  by.col(around_) = steps_[period] * curvature_ * turned;
  if (period == 1) by.col(2) = unit_ * further_ * turned;
  return by;
}

Mat3 Image::by_periods(const Vec3& f, const Vec3& y, int first, int second) const {
  const Complex p = plane(y), force = plane(f), by_arc = turned_ * (1.0 + i * curvature_ * p);
  const double arc_arc = dot(force, i * curvature_ * by_arc),
               arc_curvature = dot(force, i * further_ * by_arc + i * turned_ * p),
               curvature_curvature = dot(force, further_ * further_ * (further_ * arc_[2] - turned_ * p));
  const double curls_first = first == 1 ? unit_ : 0, curls_second = second == 1 ? unit_ : 0;
  Mat3 by = Mat3::Zero();
  by(around_, around_) = steps_[first] * steps_[second] * arc_arc;
  by(around_, 2) = steps_[first] * curls_second * arc_curvature;
  by(2, around_) = curls_first * steps_[second] * arc_curvature;
  by(2, 2) = curls_first * curls_second * curvature_curvature;
  return by;
}

OnImage carried_back(const Image& image, const Eigen::Matrix<double, 3, 4>& points,
                     const Eigen::Matrix<double, 3, 4>& forces) {
  OnImage back{image.turn().transpose() * forces, Periods::Zero()};
  for (int k = 0; k < 4; ++k)
    for (int period = 0; period < 2; ++period)
      back.periods.col(period) += image.by_period(points.col(k), period).transpose() * forces.col(k);
  return back;
}

Cylinder cylinder(const PeriodicCell& cell, const Periods& periods) { return {curvature(cell, periods), around(cell)}; }

// In the plane across the axis 1 + iκp = (1 - κh) exp(iκu), with the arc u and the height h.

Vec3 rolled_out(const Vec3& place, const Cylinder& on, double middle) {
  const double curvature = on.curvature;
  if (curvature == 0) return place;
  const Complex p(place[on.around], place.z()), from_axis = 1.0 + i * curvature * p;
  Vec3 flat = place;
  flat[on.around] = (middle + std::arg(std::polar(1.0, -middle) * from_axis)) / curvature;
  // (1 - |1 + iκp|) / κ without taking two like numbers from each other
  flat.z() = (2 * p.imag() - curvature * std::norm(p)) / (1 + std::abs(from_axis));
  return flat;
}

Vec3 rolled_up(const Vec3& flat, const Cylinder& on) {
  const double arc_length = flat[on.around], angle = on.curvature * arc_length;
  const Complex there = arc_length * arc(angle)[0] + i * flat.z() * std::polar(1.0, angle);
  Vec3 place = flat;
  place[on.around] = there.real();
  place.z() = there.imag();
  return place;
}

double middle_angle(const Points& places, const Cylinder& on) {
  Complex sum = 0;
  for (const auto& place : places.colwise()) sum += 1.0 + i * on.curvature * Complex(place[on.around], place.z());
  return std::arg(sum);
}

Points rolled_out(const PeriodicCell& cell, const Points& q) {
  const Cylinder on = cylinder(cell, q.rightCols<2>());
  const double middle = middle_angle(q.leftCols(q.cols() - 2), on);
  Points flat = q;
  for (Eigen::Index k = 0; k + 2 < q.cols(); ++k) flat.col(k) = rolled_out(Vec3(q.col(k)), on, middle);
  flat(2, q.cols() - 1) = 0;
  return flat;
}

}  // namespace wale
