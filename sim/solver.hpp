/// The contract of time: a solver moves a State on, one accepted step at a time.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sim/effect.hpp"
#include "sim/scene.hpp"

namespace wale {

class World;

enum class Progress { stepped, arrived, failed };

/// How steps on which no solution was found, or none that is finite, were tried again.
struct Retries {
  long halved = 0;     ///< shorter
  long continued = 0;  ///< on from where they got, as the load stays
  long damped = 0;     ///< held back by inertia, once they could not be shorter
  long detoured = 0;   ///< with success, from where another contact law is balanced
};

/// What a run has cost so far.
struct Effort {
  long accepted = 0, rejected = 0, evaluations = 0, factorizations = 0;
  double spared = 0;  ///< of the evaluations: each counts as the share of the control points that slept
  Retries retries{};
  std::string failure;  ///< one sentence, when advance() answered `failed`
};

/// A solver is made from a World and a State, and owns that state while it lives. It keeps no other memory
/// that would change the answer: a solver made from state() goes on as this one would. (One that lets parts sleep
/// remembers for how long others have been at rest, which changes the answer by less than sleep does.)
class Solver {
 public:
  virtual ~Solver() = default;
  virtual Progress advance(double until) = 0;  ///< one accepted step, never past `until`, s
  virtual const State& state() const = 0;      ///< after the last accepted step
  virtual State at(double t) const = 0;        ///< within the last step, to the solver's own order
  virtual const Effort& effort() const = 0;
  /// The largest residual force on a control point in state(), N; nothing from a solver that follows a motion, or
  /// before its first step.
  virtual std::optional<double> residual() const { return {}; }
  /// Balances state() further, after advance() has arrived. False if its residual does not come below `newtons`.
  virtual bool sharpen([[maybe_unused]] double newtons) { return false; }
};

/// `world` must outlive the solver. One that follows a motion is given a periodic fabric only if its guide leaves no
/// period free, and goes to no time beyond one at which that turns; nothing of it sleeps.
std::unique_ptr<Solver> make(const RungeKutta&, World& world, State);
/// `world` must be lagged if anything in it depends on velocity.
std::unique_ptr<Solver> make(const Implicit&, World& world, State);
/// The steps of the spec are taken as seconds.
std::unique_ptr<Solver> make(const QuasiStatic&, World& world, State);
/// QuasiStatic::tolerance as a force, N.
double allowed_residual(const QuasiStatic&, const Fabric&);

}  // namespace wale
