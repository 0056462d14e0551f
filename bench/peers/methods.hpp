/// One answer for every method: our solvers and those of SUNDIALS on the same world from the same state.
#pragma once

#include <string>

#include "sim/solver.hpp"
#include "sim/world.hpp"

namespace wale::peers {

/// What a method found, and what it cost.
struct Answer {
  State state;
  long steps = 0, evaluations = 0, factorizations = 0;
  double processor = 0, wall = 0;  ///< s
  std::string failure;             ///< one sentence; empty if it arrived
};

/// Of the error a step.
struct Accuracy {
  double relative = 1e-4;        ///< to the state
  double absolute = 1e-8;        ///< of positions, m
  double absolute_speed = 1e-8;  ///< of velocities, m/s; only CVODE tells them apart, the others take `absolute`
};

/// How hard an equilibrium is sought.
struct Rest {
  double tolerance = 0.05;  ///< largest residual force on a control point over EI/d²
  int samples = 1;          ///< load steps at least
};

/// Explicit pairs of ARKODE, by order(embedded order).
enum class Pair { zonneveld_43, sayfy_aburub_43, cash_karp_54, dormand_prince_54 };

// The motion q'' = M⁻¹ f from `start` to time `until`.
Answer move_by_runge_kutta(World&, const State& start, double until, const Accuracy&, RungeKutta::Method);
Answer move_by_arkode(World&, const State& start, double until, const Accuracy&, Pair);
/// Variable-order BDF; Newton's matrix by GMRES with difference quotients of f, preconditioned by CHOLMOD's factor of
/// M/γ² + C/γ + K with the convex part of K.
Answer move_by_cvode(World&, const State& start, double until, const Accuracy&);

// Rest positions as the load parameter goes from start.t to `until`.
Answer rest_by_quasi_static(World&, const State& start, double until, const Rest&);
/// Newton with line search; its matrix by GMRES on the exact second derivative, preconditioned as quasi_static does.
Answer rest_by_kinsol(World&, const State& start, double until, const Rest&);
/// Motion without mass downhill, x' = f, by CVODE's BDF until the residual is met; linear systems as for KINSOL.
Answer rest_by_flow(World&, const State& start, double until, const Rest&);

}  // namespace wale::peers
