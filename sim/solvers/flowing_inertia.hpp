/// The inertia of a periodic fabric of which some periods are free, as a step of an implicit solver has it.
#pragma once

#include "sim/world.hpp"

namespace wale {

/// By what may move, inertia against accelerations a of the columns of State::q is PᵀM P a + W a, where P takes what a
/// column flows with its free periods, and less what moving yarn carries across them, Σ M u ⊗ H⁻¹ u. Both are taken
/// where the step is expected to end, so that an energy has them as its slopes.
class FlowingInertia {
 public:
  /// `world` must outlive it.
  explicit FlowingInertia(const World& world);

  /// Whether a period is free. If none is, P and all that depends on periods does nothing.
  bool flows() const;
  /// From now on P is that at `expected`, to be called before all others if a period is free.
  void look_at(const State& expected);
  /// PᵀM P x + W x; M x if no period is free.
  Points times(const Points& x) const;
  /// P x; x if no period is free.
  Points beside(const Points& x) const;
  /// The force on the periods of what moving yarn carries, N; zero if none is free.
  const Eigen::Matrix<double, 3, 2>& carried() const { return carried_; }
  /// K += `factor` times what times() has beyond M, in kg; by all columns.
  void add_to(Stiffness& K, double factor) const;

 private:
  Eigen::Matrix<double, 3, 2> of_periods(const Points& x) const;

  const World& world_;
  Eigen::Matrix2Xd places_;  // in periods
  Eigen::Matrix<double, 3, 2> carried_ = Eigen::Matrix<double, 3, 2>::Zero();
};

}  // namespace wale
