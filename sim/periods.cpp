#include "sim/periods.hpp"

#include <Eigen/LU>

#include "sim/image.hpp"

namespace wale {
namespace {

using Plane = Eigen::Matrix2d;  // both periods, by x and y

}  // namespace

void PeriodGuide::lead(const PeriodicCell& cell, State& state) const {
  Cylinder on = cell.may_curl() ? cylinder(cell, state.q.rightCols<2>()) : Cylinder{};
  if (on.curvature != 0) state.q = rolled_out(cell, state.q);
  stretch(state);
  if (curl.how == How::led) on.curvature = curl.length(state.t);
  if (on.curvature == 0) return;
  for (Eigen::Index k = 0; k + 2 < state.q.cols(); ++k) state.q.col(k) = rolled_up(state.q.col(k), on);
  state.q(2, state.q.cols() - 1) = on.curvature * curl_unit(cell);
}

/// Of a flat fabric.
void PeriodGuide::stretch(State& state) const {
  const Plane before = state.q.topRightCorner<2, 2>();
  Plane after = before;
  if (course.how == How::led) after(0, 0) = course.length(state.t);
  if (wale.how == How::led) after(1, 1) = wale.length(state.t);
  if (lean.how == How::led) after(0, 1) = lean.length(state.t);
  if (after != before) state.q.topRows<2>() = (after * before.inverse() * state.q.topRows<2>()).eval();
}

bool PeriodGuide::pace(State& state, double until) const {
  // Times of schedules are met to rounding only.
  const double between = (state.t + until) / 2;
  const Plane before = state.v.topRightCorner<2, 2>();
  Plane after = before;
  const auto pace_of = [between](const Part& part, double& rate) {
    if (part.how != How::free) rate = part.how == How::led ? part.length.rate(between) : 0;
  };
  pace_of(course, after(0, 0));
  pace_of(wale, after(1, 1));
  pace_of(lean, after(0, 1));
  if (after == before) return false;
  state.v.topRows<2>() += (after - before) * in_periods(state.q, state);
  state.v.topRightCorner<2, 2>() = after;
  return true;
}

Eigen::Matrix<double, 3, 2> PeriodGuide::mobility() const {
  Eigen::Matrix<double, 3, 2> free = Eigen::Matrix<double, 3, 2>::Zero();
  free(0, 0) = course.how == How::free;
  free(1, 1) = wale.how == How::free;
  free(0, 1) = lean.how == How::free;
  free(2, 1) = curl.how == How::free;
  return free;
}

Eigen::Matrix2Xd in_periods(const Points& x, const State& at) {
  const Plane periods = at.q.topRightCorner<2, 2>();
  return periods.inverse() * x.topRows<2>();
}

Points beside_flow(const State& at) { return at.v - at.v.rightCols<2>() * in_periods(at.q, at); }

Eigen::Matrix<double, 3, 2> force_on_flow(const Points& force, const State& at, const Mass& mass) {
  const Points u = beside_flow(at);
  return force * in_periods(at.q, at).transpose() + mass.times(u) * in_periods(u, at).transpose();
}

}  // namespace wale
