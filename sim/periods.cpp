#include "sim/periods.hpp"

#include <Eigen/LU>

namespace wale {

void PeriodGuide::lead(State& state) const {
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
  return free;
}

}  // namespace wale
