/// Finds the least of an increment nearest downhill of a state.
#pragma once

#include "sim/solver.hpp"
#include "sim/solvers/cholesky.hpp"
#include "sim/solvers/increment.hpp"
#include "sim/solvers/leeway.hpp"
#include "sim/world.hpp"

namespace wale {

/// Trust-region Newton on the energy (Steihaug 1983): conjugate gradients on the exact second derivative, which may be
/// indefinite where yarns are about to slip, preconditioned by the Cholesky factor of its Gauss-Newton part.
/// Neighbours move no further against each other in one iteration than leaves every pair of yarns apart, and yarns that
/// were not neighbours are looked for on the way, so no yarn can pass through another.
class Equilibrium {
 public:
  /// `increment` must outlive it.
  explicit Equilibrium(Increment& increment);

  /// When to stop: at the first of both that is met.
  struct Goal {
    double residual = 0;  ///< the largest residual force on a control point, N
    double move = 0;      ///< how far a whole Newton step moves any of them, m
    double unmet = 0;     ///< share of the control points on which a larger force may be left
  };
  enum class Answer { found, gave_up };
  /// Moves `state.q` until the goal is met.
  Answer relax(State& state, const Goal& goal, int iterations, Effort& effort);

  /// Moves `state` along `move`, no further than neighbours may at once and no yarn passes through another: what all of
  /// the fabric does together goes on, however little may move where neighbours move most. Answers how much of that.
  double follow(State& state, const Points& move);
  /// How far `move` takes neighbours against each other, over what they may at once.
  double share_of(const Points& move) const { return leeway_.share(move); }
  /// x := K⁻¹ x with the last factor of relax(), under the constraints.
  void precondition(Eigen::VectorXd& x) const;
  /// Lets the next relax() depend on nothing that came before, so that a state taken up again leads to the same bits.
  void forget() {
    cholesky_.forget();
    world_.forget();
  }
  /// The largest residual force after relax(), N.
  double residual() const { return residual_; }
  /// The control point that it acts on: a column of what may move.
  int worst_point() const { return worst_point_; }

 private:
  struct Step {
    Eigen::VectorXd move;
    double promised = 0;  // decrease of energy by the quadratic model, J
    bool limited = false;
  };
  struct Trial {
    State state;
    double energy = 0;  // J
    Points force;       // N
  };
  Trial attempt(const State& from, const Eigen::VectorXd& move, Effort& effort);
  void correct(Trial& trial, double tolerance, Effort& effort);
  bool factor(const Trial& now, const Goal& goal, Effort& effort);
  Eigen::VectorXd shifts(const Points& force, const Goal& goal) const;
  std::vector<int> places(const Trial& now, const Goal& goal) const;
  bool balance_places(Trial& now, const Goal& goal, Effort& effort);
  Step downhill(const Points& force);
  double evaluate(const State& at, Points* force, Effort& effort);
  double clearance_at(const State& state) const;
  void look_around(const State& state);
  bool stays_apart(const State& from, const Points& move);
  double share(const Eigen::VectorXd& move) const;
  double steps_to_edge(const Eigen::VectorXd& move, const Eigen::VectorXd& along) const;
  void release(Points& force) const;  // takes out what the clamps bear
  bool is_met(const Goal& goal, const Trial& now) const;
  bool adapt(const Step& step, double gain);

  Increment& increment_;
  World& world_;
  Stiffness second_;  // the exact one, but while it is factored
  Cholesky cholesky_;
  Leeway leeway_;
  double thickness_ = 0;  // of the thinnest yarn, m
  double reach_ = 0;      // of what neighbours may move against each other in one iteration
  double secant_ = 0;     // of friction, see Load
  double clearance_ = 0;  // over the diameter, where the iteration stands
  double residual_ = 0;
  int worst_point_ = 0;
  bool is_of_places_ = false;  // of some control points, while the others stay
  int inner_ = 0;              // steps of conjugate gradients with the factor at hand
};

}  // namespace wale
