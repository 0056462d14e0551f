#include "compiler/passes/interpolate.hpp"

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

}  // namespace wale
