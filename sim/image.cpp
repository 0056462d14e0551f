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

double curl_unit(const PeriodicCell& cell) { return cell.wale.y() * cell.wale.y(); }

double curvature(const PeriodicCell& cell, const Periods& periods) { return periods(2, 1) / curl_unit(cell); }

Image::Image(const PeriodicCell& cell, const Periods& periods, const Eigen::Vector2i& steps)
    : steps_(steps.cast<double>()), unit_(1 / curl_unit(cell)), curvature_(wale::curvature(cell, periods)) {
  const Eigen::Vector2d flat = periods.topRows<2>() * steps_;
  along_ = flat.y();
  turned_ = std::polar(1.0, curvature_ * along_);
  arc_ = arc(curvature_ * along_);
  const Complex shift = along_ * arc_[0];
  turn_ << 1, 0, 0, 0, turned_.real(), -turned_.imag(), 0, turned_.imag(), turned_.real();
  shift_ << flat.x(), shift.real(), shift.imag();
}

// In the plane across the axis X = exp(iκu) p + u arc(κu), with u = D_y, of which ∂X/∂u = exp(iκu) (1 + iκp).

Mat3 Image::by_period(const Vec3& y, int period) const {
  const Complex p = plane(y), by_arc = turned_ * (1.0 + i * curvature_ * p),
                by_curvature = along_ * (i * turned_ * p + along_ * arc_[1]);
  Mat3 by = Mat3::Zero();
  by(0, 0) = steps_[period];
  by.col(1) = steps_[period] * Vec3(0, by_arc.real(), by_arc.imag());
  if (period == 1) by.col(2) = unit_ * Vec3(0, by_curvature.real(), by_curvature.imag());
  return by;
}

Mat3 Image::mixed(const Vec3& f, int period) const {
  const Complex by_angle = std::conj(i * turned_) * plane(f);
  const Vec3 turned(0, by_angle.real(), by_angle.imag());
  Mat3 by = Mat3::Zero();
  by.col(1) = steps_[period] * curvature_ * turned;
  if (period == 1) by.col(2) = unit_ * along_ * turned;
  return by;
}

Mat3 Image::by_periods(const Vec3& f, const Vec3& y, int first, int second) const {
  const Complex p = plane(y), force = plane(f), by_arc = turned_ * (1.0 + i * curvature_ * p);
  const double arc_arc = dot(force, i * curvature_ * by_arc),
               arc_curvature = dot(force, i * along_ * by_arc + i * turned_ * p),
               curvature_curvature = dot(force, along_ * along_ * (along_ * arc_[2] - turned_ * p));
  const double curls_first = first == 1 ? unit_ : 0, curls_second = second == 1 ? unit_ : 0;
  Mat3 by = Mat3::Zero();
  by(1, 1) = steps_[first] * steps_[second] * arc_arc;
  by(1, 2) = steps_[first] * curls_second * arc_curvature;
  by(2, 1) = curls_first * steps_[second] * arc_curvature;
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

// 1 + iκp = (1 - κh) exp(iκu), with the arc u and the height h.

Vec3 rolled_out(const Vec3& place, double curvature) {
  if (curvature == 0) return place;
  const Complex p(place.y(), place.z()), from_axis = 1.0 + i * curvature * p;
  // (1 - |1 + iκp|) / κ without taking two like numbers from each other
  const double height = (2 * p.imag() - curvature * std::norm(p)) / (1 + std::abs(from_axis));
  return {place.x(), std::arg(from_axis) / curvature, height};
}

Vec3 rolled_up(const Vec3& flat, double curvature) {
  const double angle = curvature * flat.y();
  const Complex there = flat.y() * arc(angle)[0] + i * flat.z() * std::polar(1.0, angle);
  return {flat.x(), there.real(), there.imag()};
}

Points rolled_out(const PeriodicCell& cell, const Points& q) {
  const double bent = curvature(cell, q.rightCols<2>());
  Points flat = q;
  for (Eigen::Index k = 0; k + 2 < q.cols(); ++k) flat.col(k) = rolled_out(Vec3(q.col(k)), bent);
  flat(2, q.cols() - 1) = 0;
  return flat;
}

}  // namespace wale
