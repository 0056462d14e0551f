/// What sleep spares a motion that is followed by Runge-Kutta steps, and how far it leads away: a jersey at rest is
/// struck in its middle, by a hook that pulls a stitch or by a ball. Each repetition follows the motion with sleep and
/// without.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <ctime>
#include <map>

#include "sim/solver.hpp"
#include "sim/solvers/even_motion.hpp"
#include "tests/support/resting_jersey.hpp"

namespace wale {
namespace {

constexpr double duration = 200e-6, way = 0.5e-3;  // s, m

const RestingJersey& jersey(int stitches) {
  static std::map<int, RestingJersey> made;
  return made.try_emplace(stitches, stitches).first->second;
}

struct Followed {
  State state;
  Effort effort;
  double seconds = 0;  // of the processor
};

Followed follow(const RestingJersey& of, const EffectSpec& striker, double sleep) {
  const auto world = of.world({Drag{}, striker});
  const std::clock_t begun = std::clock();
  const auto solver = make(RungeKutta{.relative = 1e-3, .absolute = 1e-6, .sleep = sleep}, *world, of.state());
  while (solver->advance(duration) == Progress::stepped) {
  }
  return {solver->state(), solver->effort(), static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC};
}

/// Arguments: stitches each way, threshold in 1e-5, whether it is a ball.
void strike(benchmark::State& bench) {
  omp_set_num_threads(1);
  const RestingJersey& of = jersey(static_cast<int>(bench.range(0)));
  const double sleep = 1e-5 * static_cast<double>(bench.range(1));
  const Schedule when = Schedule::ramp(0, 1, duration);
  const EffectSpec striker = bench.range(2) ? EffectSpec(of.ball(way, when)) : EffectSpec(of.hook(way, when));
  for (auto _ : bench) {
    const Followed all = follow(of, striker, 0), some = follow(of, striker, sleep);
    bench.counters["faster"] = all.seconds / some.seconds;
    bench.counters["seconds_without"] = all.seconds;
    bench.counters["spared"] = some.effort.spared / static_cast<double>(some.effort.evaluations);
    bench.counters["off_of_way"] =
        largest_motion(all.state.q, some.state.q) / largest_motion(all.state.q, of.state().q);
  }
}
BENCHMARK(strike)
    ->Name("sleep/strike")
    ->ArgNames({"stitches", "sleep_1e-5", "ball"})
    ->ArgsProduct({{20}, {1000, 100, 10}, {0, 1}})
    ->Args({40, 100, 0})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace wale
