/// Slopes by central differences of fourth order, and a sparse stiffness as a dense matrix.
#pragma once

#include <functional>

#include "sim/stiffness.hpp"

namespace wale {

/// The slope of `f` by every coordinate of `x`, one column a coordinate.
inline Eigen::MatrixXd slope_of(const std::function<Eigen::VectorXd(const Points&)>& f, const Points& x, double step) {
  Eigen::MatrixXd slope;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto moved = [&](double by) {
      Points there = x;
      there.reshaped()[i] += by * step;
      return f(there);
    };
    const Eigen::VectorXd column = (8 * (moved(1) - moved(-1)) - (moved(2) - moved(-2))) / (12 * step);
    if (slope.size() == 0) slope.resize(column.size(), x.size());
    slope.col(i) = column;
  }
  return slope;
}

inline Eigen::MatrixXd dense(const Stiffness& stiffness) {
  const Eigen::Index n = 3 * stiffness.points();
  Eigen::MatrixXd result(n, n);
  Eigen::VectorXd column;
  for (Eigen::Index i = 0; i < n; ++i) {
    stiffness.multiply(Eigen::VectorXd::Unit(n, i), column);
    result.col(i) = column;
  }
  return result;
}

}  // namespace wale
