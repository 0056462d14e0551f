#include "bench/peers/methods.hpp"
#include "bench/peers/stopwatch.hpp"

namespace wale::peers {
namespace {

Answer solve(const SolverSpec& spec, World& world, const State& start, double until) {
  const Stopwatch watch;
  const auto solver = std::visit([&](const auto& of) { return make(of, world, start); }, spec);
  while (solver->advance(until) == Progress::stepped) continue;
  const Effort& effort = solver->effort();
  return {.state = solver->state(),
          .steps = effort.accepted,
          .evaluations = effort.evaluations,
          .factorizations = effort.factorizations,
          .processor = watch.processor(),
          .wall = watch.wall(),
          .failure = effort.failure};
}

}  // namespace

Answer move_by_runge_kutta(World& world, const State& start, double until, const Accuracy& accuracy,
                           RungeKutta::Method method) {
  return solve(RungeKutta{.method = method, .relative = accuracy.relative, .absolute = accuracy.absolute}, world, start,
               until);
}

Answer rest_by_quasi_static(World& world, const State& start, double until, const Rest& rest) {
  const double load = until - start.t;
  return solve(
      QuasiStatic{.tolerance = rest.tolerance, .first_step = load / rest.samples, .smallest_step = 1e-3 * load}, world,
      start, until);
}

}  // namespace wale::peers
