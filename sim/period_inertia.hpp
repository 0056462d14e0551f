/// What free periods weigh in a motion.
#pragma once

#include "sim/periods.hpp"

namespace wale {

/// An endless fabric would have to move without end for its periods to change, so that only a repeat's own yarn is
/// taken: each period H has the inertia W = m (10 d/H)²/12, kg, of strips ten diameters d of the first yarn wide, where
/// m is the mass of a repeat and H as the compiler laid it. Any number of repeats then moves alike, and slow motion
/// does not depend on it. A fabric that flows with its periods moves by q'' = M⁻¹ f + H'' H⁻¹ q and
/// W H'' = force_on_flow(), which keeps ½ u·M u + ½ W H'² + V.
class PeriodInertia {
 public:
  explicit PeriodInertia(const Fabric&);

  /// Of the course and the wale period, kg.
  const Eigen::Vector2d& masses() const { return masses_; }
  /// ½ W H'² of what is free, J.
  double kinetic_energy(const State& at, const PeriodGuide&) const;
  /// Adds what free periods give to `acceleration`, which is M⁻¹ `force`, m/s²; by the columns of State::q.
  void add_to(Points& acceleration, const Points& force, const State& at, const PeriodGuide&, const Mass&) const;

 private:
  Eigen::Vector2d masses_ = Eigen::Vector2d::Zero();
};

}  // namespace wale
