#include "sim/solvers/flowing_inertia.hpp"

namespace wale {

FlowingInertia::FlowingInertia(const World& world) : world_(world) {}

bool FlowingInertia::flows() const { return world_.fabric().cell && world_.guide().leaves_free(); }

void FlowingInertia::look_at(const State& expected) {
  places_ = in_periods(expected.q, expected);
  const Points u = beside_flow(expected);
  carried_ = world_.mass().times(u) * in_periods(u, expected).transpose();
}

/// What of a motion is of free periods.
Eigen::Matrix<double, 3, 2> FlowingInertia::of_periods(const Points& x) const {
  return world_.guide().mobility().cwiseProduct(x.rightCols<2>());
}

Points FlowingInertia::beside(const Points& x) const {
  if (!flows()) return x;
  return x - of_periods(x) * places_;
}

Points FlowingInertia::times(const Points& x) const {
  Points inertia = world_.mass().times(beside(x));
  if (flows())
    inertia.rightCols<2>() +=
        of_periods(x) * world_.period_inertia().masses().asDiagonal() - inertia * places_.transpose();
  return inertia;
}

void FlowingInertia::add_to(Stiffness& K, double factor) const {
  const int points = static_cast<int>(world_.fabric().points.cols());
  Points along = Points::Zero(3, places_.cols());
  along.topRows<2>() = places_;
  along.rightCols<2>().setZero();  // the periods have none of M
  const Points carried = world_.mass().times(along);
  for (int j = 0; j < points; ++j)
    for (int period = 0; period < 2; ++period)
      K.add(j, points + period, -factor * carried(period, j) * Mat3::Identity());
  const Eigen::Matrix3d both = along * carried.transpose();
  for (int first = 0; first < 2; ++first)
    for (int second = first; second < 2; ++second)
      K.add(points + first, points + second,
            factor * (both(first, second) + (first == second ? world_.period_inertia().masses()[first] : 0)) *
                Mat3::Identity());
}

}  // namespace wale
