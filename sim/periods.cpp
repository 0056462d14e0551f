#include "sim/periods.hpp"

#include <Eigen/LU>

#include "sim/image.hpp"

namespace wale {

void PeriodGuide::lead(const PeriodicCell& cell, State& state) const {
  Cylinder on = cell.curls == Curls::never ? Cylinder{} : cylinder(cell, state.q.rightCols<2>());
  if (on.curvature != 0) state.q = rolled_out(cell, state.q);
  stretch(state);
  if (curl.how == How::led) on.curvature = curl.length(state.t);
  if (on.curvature == 0) return;
  for (Eigen::Index k = 0; k + 2 < state.q.cols(); ++k) state.q.col(k) = rolled_up(state.q.col(k), on);
  state.q(2, state.q.cols() - 1) = on.curvature * curl_unit(cell);
}

/// Of a flat fabric.
void PeriodGuide::stretch(State& state) const {
  using Plane = Eigen::Matrix2d;  // both periods, by x and y
  const Plane before = state.q.topRightCorner<2, 2>();
  Plane after = before;
  if (course.how == How::led) after(0, 0) = course.length(state.t);
  if (wale.how == How::led) after(1, 1) = wale.length(state.t);
  if (lean.how == How::led) after(0, 1) = lean.length(state.t);
  if (after != before) state.q.topRows<2>() = (after * before.inverse() * state.q.topRows<2>()).eval();
}

Eigen::Matrix<double, 3, 2> PeriodGuide::mobility() const {
  Eigen::Matrix<double, 3, 2> free = Eigen::Matrix<double, 3, 2>::Zero();
  free(0, 0) = course.how == How::free;
  free(1, 1) = wale.how == How::free;
  free(0, 1) = lean.how == How::free;
  free(2, 1) = curl.how == How::free;
  return free;
}

}  // namespace wale
