/// Finds the rest position nearest downhill of a state, at a fixed load.
#pragma once

#include "sim/solver.hpp"
#include "sim/solvers/cholesky.hpp"
#include "sim/world.hpp"

namespace wale {

/// Trust-region Newton on the energy (Steihaug 1983): conjugate gradients on the exact second derivative, which may be
/// indefinite where yarns are about to slip, preconditioned by the Cholesky factor of its Gauss-Newton part.
/// No control point moves further in one iteration than leaves every pair of yarns apart, so no yarn can pass
/// through another.
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
  struct Step {
    Eigen::VectorXd move;
    double promised = 0;  // decrease of energy by the quadratic model, J
    bool limited = false;
  };
  bool factor(const State& at, Effort& effort);
  Step downhill(const Points& force) const;
  double evaluate(const State& at, Points* force, Effort& effort);
  void release(Points& force) const;  // takes out what the clamps bear
  void precondition(Eigen::VectorXd& x) const;

  World& world_;
  Stiffness exact_, convex_;
  Cholesky cholesky_;
  double thickness_ = 0;  // of the thinnest yarn, m
  double reach_ = 0;      // how far a control point may move in one iteration, m
  double shift_ = 0;      // Levenberg's, N/m: keeps soft modes within reach while stiff ones take their whole step
  double residual_ = 0;
};

}  // namespace wale
