/// The force evaluation of a pull, effect by effect, on one and two threads with every instruction set.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <map>

#include "bench/jersey_swatch.hpp"
#include "sim/effects/beads.hpp"
#include "sim/kernels/instruction_set.hpp"

namespace wale {
namespace {

/// A swatch between two grips and two plates, nearly at rest.
class Pulled {
 public:
  Pulled(int wales, int courses) : jersey_(wales, courses, shrinkage, JerseySwatch::Mounting::gripped) { relax(); }

  double evaluate() { return jersey_.evaluate(); }
  double add(std::size_t effect) {
    double energy = 0;
    Load load{.energy = &energy, .force = &force_};
    jersey_.world().effects()[effect]->add(jersey_.state(), load);
    return energy;
  }
  void prepare() { jersey_.world().prepare(jersey_.state()); }

  const Fabric& fabric() const { return jersey_.fabric(); }
  const Beads& beads() const { return *jersey_.world().parts().made_beads.begin()->second; }
  std::size_t effects() const { return jersey_.world().effects().size(); }

  /// Bead pairs, and what share of the listed pairs touches.
  void count(benchmark::State& state) const {
    double bead_pairs = 0, touching = 0;
    for (std::size_t p = 0; p < beads().pairs().size(); ++p) {
      const auto [a, b, image] = beads().pairs()[p];
      bead_pairs += beads().count(a) * beads().count(b);
      touching += beads().distance(p) < beads().diameter(a, b);
    }
    const auto pairs = static_cast<double>(beads().pairs().size());
    state.counters["segments"] = fabric().segment_count();
    state.counters["pairs"] = pairs;
    state.counters["beads_a_pair"] = bead_pairs / pairs;
    state.counters["touching"] = touching / pairs;
  }

 private:
  // Of the yarn as laid: about what tightening takes off.
  static constexpr double shrinkage = 0.8;

  /// Downhill with momentum (Bitzek et al. 2006), no point further than a hundredth of a diameter at once.
  void relax() {
    const double reach = 0.01 * fabric().materials.front().diameter;
    Points speed = Points::Zero(3, jersey_.state().q.cols());
    for (int i = 0; i < 300; ++i) {
      jersey_.evaluate();
      const Points& force = jersey_.force();
      const double power = speed.cwiseProduct(force).sum();
      if (power < 0) speed.setZero();
      speed = 0.9 * speed + force * (0.1 * std::max(speed.norm(), 1e-12) / force.norm()) + 1e-3 * force;
      const double furthest = std::sqrt(speed.colwise().squaredNorm().maxCoeff());
      if (furthest > reach) speed *= reach / furthest;
      jersey_.move(speed);
    }
    jersey_.evaluate();
    force_ = jersey_.force();
  }

  JerseySwatch jersey_;
  Points force_;  // that add() adds to
};

/// Arguments: wales, courses, instruction set, threads.
Pulled* pulled(benchmark::State& state) {
  static std::map<std::pair<int, int>, Pulled> made;
  const auto set = static_cast<InstructionSet>(state.range(2));
  if (!supports(set)) {
    state.SkipWithError("not on this machine");
    return nullptr;
  }
  set_instruction_set(set);
  omp_set_num_threads(static_cast<int>(state.range(3)));
  const std::pair size{static_cast<int>(state.range(0)), static_cast<int>(state.range(1))};
  Pulled& of = made.try_emplace(size, size.first, size.second).first->second;
  state.SetLabel(std::string(name(set)));
  of.count(state);
  return &of;
}

/// The time of one piece of work, `each` to an iteration.
benchmark::Counter time_of(double each) {
  return benchmark::Counter(each, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void whole(benchmark::State& state) {
  Pulled* of = pulled(state);
  if (!of) return;
  for (auto _ : state) benchmark::DoNotOptimize(of->evaluate());
}

/// What contact costs: locate the beads, measure all listed pairs, push those that touch.
void contact(benchmark::State& state) {
  Pulled* of = pulled(state);
  if (!of) return;
  for (auto _ : state) {
    of->prepare();
    benchmark::DoNotOptimize(of->add(2));
  }
  const auto pairs = static_cast<double>(of->beads().pairs().size());
  state.counters["a_pair"] = time_of(pairs);
  state.counters["a_bead_pair"] = time_of(pairs * state.counters["beads_a_pair"]);
}

void measure(benchmark::State& state) {
  Pulled* of = pulled(state);
  if (!of) return;
  for (auto _ : state) of->prepare();
  state.counters["a_pair"] = time_of(static_cast<double>(of->beads().pairs().size()));
}

/// What all but contact costs.
void along(benchmark::State& state) {
  Pulled* of = pulled(state);
  if (!of) return;
  for (auto _ : state)
    for (std::size_t effect = 0; effect < of->effects(); ++effect)
      if (effect != 2) benchmark::DoNotOptimize(of->add(effect));
  state.counters["a_segment"] = time_of(of->fabric().segment_count());
}

/// The fifth argument is the effect.
void one(benchmark::State& state) {
  Pulled* of = pulled(state);
  if (!of) return;
  for (auto _ : state) benchmark::DoNotOptimize(of->add(static_cast<std::size_t>(state.range(4))));
  state.counters["a_segment"] = time_of(of->fabric().segment_count());
}

void all(benchmark::internal::Benchmark* of) {
  of->ArgsProduct({{12}, {13}, {0, 1, 2}, {1, 2}})
      ->ArgsProduct({{41}, {40}, {0, 1, 2}, {1, 2}})
      ->Unit(benchmark::kMicrosecond)
      ->UseRealTime();
}
BENCHMARK(whole)->Apply(all);
BENCHMARK(contact)->Apply(all);
BENCHMARK(measure)->Apply(all);
BENCHMARK(along)->Apply(all);
BENCHMARK(one)
    ->ArgsProduct({{41}, {40}, {0, 1, 2}, {1}, {0, 1, 2, 3, 4}})
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();

}  // namespace
}  // namespace wale
