#include "compiler/passes/interpolate.hpp"

#include <cmath>
#include <stdexcept>

#include "sim/lapack.hpp"

namespace wale {

Points interpolate(const Points& through, const Vec3& from, const Vec3& to) {
  constexpr int lower = 2, upper = 2, diagonal = lower + upper;
  const auto n = through.cols() - 1;
  Eigen::MatrixXd band = Eigen::MatrixXd::Zero(2 * lower + upper + 1, n + 3), right(n + 3, 3);
  const auto set = [&](Eigen::Index row, Eigen::Index column, double value) {
    band(diagonal + row - column, column) = value;
  };
  set(0, 0, -0.5);
  set(0, 2, 0.5);
  right.row(0) = from.transpose();
  for (Eigen::Index k = 0; k <= n; ++k) {
    set(k + 1, k, 1.0 / 6);
    set(k + 1, k + 1, 2.0 / 3);
    set(k + 1, k + 2, 1.0 / 6);
    right.row(k + 1) = through.col(k).transpose();
  }
  set(n + 2, n, -0.5);
  set(n + 2, n + 2, 0.5);
  right.row(n + 2) = to.transpose();
  if (lapack::dgbsv(lower, upper, band, right) != 0)
    throw std::runtime_error("the spline through a yarn's points could not be solved");
  return right.transpose();
}

/// Unser's filter: the inverse of the basis (1/6, 2/3, 1/6) is √3 z^|j| with z = √3 - 2.
Points interpolate_periodic(const Points& through, const Vec3& period) {
  constexpr int reach = 30;  // |z|^30 is below the precision of a double
  const auto n = static_cast<int>(through.cols());
  const auto point = [&](int k) {
    const int periods = k >= 0 ? k / n : -((n - 1 - k) / n);
    return Vec3(through.col(k - periods * n) + periods * period);
  };
  Points q(3, n + 3);
  for (int k = 0; k < n; ++k) {
    double weight = std::sqrt(3.0);
    Vec3 sum = weight * point(k);
    for (int j = 1; j <= reach; ++j) {
      weight *= std::sqrt(3.0) - 2;
      sum += weight * (point(k - j) + point(k + j));
    }
    q.col(k + 1) = sum;
  }
  q.col(0) = q.col(n) - period;
  for (int k = 0; k < 3; ++k) q.col(n + k) = q.col(k) + period;
  return q;
}

}  // namespace wale
