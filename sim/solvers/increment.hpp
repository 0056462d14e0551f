/// What one step of a quasi-static or an implicit solver makes least.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/solvers/flowing_inertia.hpp"
#include "sim/solvers/leeway.hpp"
#include "sim/world.hpp"

namespace wale {

/// Φ(q) = V(q) + θ D(qD; (q - q0)/θ) + ½ (q - q1)·M (q - q1)/θ², where the velocity at the end is (q - q0)/θ, the
/// acceleration (q - q1)/θ², and θ how long the step takes. That its slope is zero is the balance of forces there. D
/// has its normal forces and directions from a given qD: lagged, so that there is an energy to be made least (Li et
/// al. 2020, "Incremental potential contact"). A quasi-static step has no last term. If a period of a periodic fabric
/// is free, the last term is that of FlowingInertia.
class Increment {
 public:
  /// `world` must outlive it, and be lagged if anything in it depends on velocity.
  explicit Increment(World& world);

  /// A quasi-static step from `from`, q0, that takes `time`, s. `lagged` is qD.
  void begin(const State& lagged, double time, Points from);
  /// From now on qD is `lagged`.
  void lag(const State& lagged);
  /// Where a motion would be after `time` s at its old velocity (`coasting`, q1), and where it would be at none
  /// (`from`, q0), by the columns of State::q. `gaining` is about how it gains speed until then, m/s²: asked for only
  /// if a period is free.
  void begin(const State& lagged, double time, Points from, Points coasting, const Points& gaining = {});
  /// What inertia acts on of a motion: all of it but the flow of free periods.
  Points beside_free_periods(const Points& motion) const { return inertia_.beside(motion); }
  /// Whether the last begin() was of a motion.
  bool has_inertia() const { return coasting_.size() > 0; }
  bool dissipates() const { return dissipates_; }
  /// Brings caches up to date for V at `at`.
  void prepare(const State& at);
  /// The force -dV/dq, N, on all columns of State::q. Prepares.
  Points push(const State& at);
  /// Φ, J; and the force -dΦ/dx, N, if it is wanted, on what may move: 3 x points(). Prepares.
  double value(const State& at, Points* force);
  /// What makes a quadratic model promise less than its energy does.
  struct Caution {
    Eigen::VectorXd shift;  ///< Levenberg's, against the motion of neighbours, by column of State::q, N/m; empty: none
    double secant = 0;      ///< see Load; that of a motion, which needs its own matrix, is 0
  };
  enum class Model : std::uint8_t {
    exact,  ///< the second derivative of Φ
    convex  ///< its part that is positive semidefinite for sure
  };
  /// By what may move, N/m, at the last state prepared.
  void second(const State& at, const Leeway& leeway, const Caution&, Model, Stiffness& out);

  /// The right side of second() x = impulse(a, b) that has x = (I - θJ)⁻¹ (a, b), its positions, where J is the
  /// Jacobian of the motion and (a, b) are positions and velocities of all columns; on what may move.
  Points impulse(const Points& a, const Points& b) const;

  /// From now on these control points alone may move, ascending, and nothing is asked for but what acts on them: see
  /// World::hold(). Empty: all may. Not for a motion, nor for a fabric that is periodic or under constraints.
  void attend(std::vector<int> points);
  /// Columns of what may move: the control points, or those of a periodic fabric that do not follow others, and its
  /// periods.
  int points() const { return attended_.empty() ? world_.ties().free_columns() : static_cast<int>(attended_.size()); }
  /// The motion of all control points that goes with one of what may move.
  Points spread(const Points& move) const;
  World& world() { return world_; }

 private:
  bool flows() const { return has_inertia() && inertia_.flows(); }
  bool moves_in_part() const { return !attended_.empty() || !world_.ties().empty(); }
  void expect(const State& from, const Points& gaining);
  State moving(const State& at) const;
  void add_damping(const State& at, double secant, Stiffness& out) const;
  const Stiffness& damping_at(const State& at);
  Points gather(const Points& force) const;
  void gather(const Stiffness& by_all, Stiffness& by_free) const;
  void add_turning(const State& at, Stiffness& exact);
  void hold_periods(Stiffness& by_free) const;

  World& world_;
  bool dissipates_;
  std::vector<int> attended_;  // control points that alone may move; empty: all
  State lagged_;               // qD
  Points from_, coasting_;     // q0, q1; the latter empty without inertia
  double time_ = 1;            // θ, s
  FlowingInertia inertia_;
  Stiffness mass_;                       // kg; empty without inertia
  Stiffness damping_;                    // second derivative of D by velocity, of a motion
  bool damping_is_of_prepared_ = false;  // at the last state prepared
  Stiffness by_all_;                     // by all columns, where not all of them may move by themselves
};

}  // namespace wale
