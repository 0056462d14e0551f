/// What one step of a quasi-static or an implicit solver makes least.
#pragma once

#include "sim/solvers/leeway.hpp"
#include "sim/world.hpp"

namespace wale {

/// Φ(q) = V(q) + θ D(q0; (q - q0)/θ), where q0 is where the step began and θ how long it takes. That its slope is zero
/// is the balance of forces at the end of the step. D has its normal forces and directions from q0: lagged, so that
/// there is an energy to be made least (Li et al. 2020, "Incremental potential contact").
class Increment {
 public:
  /// `world` must outlive it, and be lagged if anything in it depends on velocity.
  explicit Increment(World& world);

  /// A step from `from` that takes `time`, s.
  void begin(const State& from, double time);
  /// Brings caches up to date for V at `at`.
  void prepare(const State& at) { world_.prepare(at, Acting::elastic); }
  /// Φ, J; and the force -dΦ/dx, N, if it is wanted, on what may move: 3 x points(). Prepares.
  double value(const State& at, Points* force);
  /// The second derivative of Φ by what may move, N/m, and its part that is positive semidefinite for sure, at the last
  /// state prepared; both with Levenberg's shift against the motion of neighbours.
  void second(const State& at, const Leeway& leeway, double shift, Stiffness& exact, Stiffness& convex);

  /// Columns of what may move: the control points, or those of a periodic fabric that do not follow others, and its
  /// periods.
  int points() const { return world_.ties().free_columns(); }
  /// The motion of all control points that goes with one of what may move.
  Points spread(const Points& move) const { return world_.ties().spread(move); }
  World& world() { return world_; }

 private:
  State moving(const State& at) const;
  void gather(Stiffness& by_all, Stiffness& by_free) const;

  World& world_;
  bool dissipates_;
  State from_;
  double time_ = 1;           // θ, s
  Stiffness damping_;         // second derivative of D by velocity
  Stiffness exact_, convex_;  // by all columns, of a periodic fabric
};

}  // namespace wale
