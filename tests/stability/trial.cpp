#include "tests/stability/trial.hpp"

#include <chrono>
#include <exception>

#include "tests/stability/invariants.hpp"

namespace wale::stability {
namespace {

// The stiffness that comes nearest to real yarn by each law, N/m: the quadratic one must be stiff to bear anything.
double stiffness_of(ContactLaw law) { return law == ContactLaw::quadratic ? 3e3 : 300; }

/// By what a case has made its stiffness differ from the default it still does.
void take_law(Material& material, ContactLaw law) {
  material.contact_stiffness *= stiffness_of(law) / stiffness_of(ContactLaw::barrier);
  material.law = law;
}

Outcome run_patiently(Results& results, const Patience& patience) {
  std::atomic<bool> enough = false;
  long steps = 0;
  const auto begun = std::chrono::steady_clock::now();
  RunOptions options;
  options.interrupt = &enough;
  options.progress = [&](const RunStatus&) {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
    enough =
        (patience.steps > 0 && ++steps >= patience.steps) || (patience.seconds > 0 && taken.count() > patience.seconds);
  };
  return run(results, options);
}

}  // namespace

SolverSpec solver_of(SolverKind kind) {
  switch (kind) {
    case SolverKind::runge_kutta:
      return RungeKutta{};
    case SolverKind::implicit:
      return Implicit{};
    case SolverKind::quasi_static:
      return QuasiStatic{.tolerance = 0.05};
  }
  return QuasiStatic{};
}

HardScene hard_scene(const HardCase& of, double rung, SolverKind kind, ContactLaw law) {
  HardScene hard = of.make(rung);
  for (Material& material : hard.scene.fabric.materials) take_law(material, law);
  auto& stages = hard.scene.stages;
  for (auto stage = static_cast<std::size_t>(hard.first_tested); stage < stages.size(); ++stage)
    stages[stage].solver = solver_of(kind);
  return hard;
}

Verdict attempt(const HardScene& hard, Results& results, const Patience& patience) {
  using End = Verdict::End;
  results.scene = hard.scene;
  Outcome outcome = Outcome::finished;
  try {
    outcome = run_patiently(results, patience);
  } catch (const std::exception& error) {
    return {End::broke, std::string("threw: ") + error.what()};
  }
  if (const auto broken = what_broke(hard, results)) return {End::broke, *broken};
  if (outcome == Outcome::interrupted) return {End::too_long, "it takes too long"};
  if (outcome == Outcome::finished) return {};
  if (results.effort.failure.empty()) return {End::broke, "it gave up without a word"};
  return {End::gave_up, results.effort.failure};
}

}  // namespace wale::stability
