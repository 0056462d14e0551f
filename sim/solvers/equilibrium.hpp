/// Finds the rest position nearest downhill of a state, at a fixed load.
#pragma once

#include "sim/solver.hpp"
#include "sim/solvers/cholesky.hpp"
#include "sim/world.hpp"

namespace wale {

/// Levenberg-Marquardt on the energy. No control point moves further in one iteration than leaves every pair of
/// yarns apart, so no yarn can pass through another.
class Equilibrium {
 public:
  explicit Equilibrium(World& world);

  enum class Answer { found, gave_up };
  /// Moves `state.q` until the largest residual force on a control point is below `tolerance`, N.
  Answer relax(State& state, double tolerance, int iterations, Effort& effort);

  /// How far a control point may move at once: a share of the smallest gap between yarns, m.
  double safe_move() const;
  /// The largest residual force after relax(), N.
  double residual() const { return residual_; }

 private:
  struct Trial {
    State state;
    double energy = 0;
  };
  bool factor(const State& at, Effort& effort);
  Eigen::VectorXd direction(const Points& force) const;
  double evaluate(const State& at, Points* force, Effort& effort);

  World& world_;
  Stiffness stiffness_;
  Cholesky cholesky_;
  double thickness_ = 0;  // of the thinnest yarn, m
  double shift_ = 0;      // Levenberg's, N/m
  double growth_ = 2;
  double residual_ = 0;
};

}  // namespace wale
