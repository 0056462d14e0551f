/// What one Newton step of a static solve is made of, on jersey swatches of 13 courses x 12 wales and of 40 x 41.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <map>

#include "bench/jersey_swatch.hpp"
#include "sim/solvers/cholesky.hpp"

namespace wale {
namespace {

constexpr double shift = 50;  // N/m, as in the middle of a pull
// Of the yarn as laid: then a control point has about as many neighbours by contact as in a relaxed swatch.
constexpr double shrinkage = 0.65;

/// A swatch and its second derivatives.
class Swatch {
 public:
  Swatch(int wales, int courses)
      : jersey_(wales, courses, shrinkage, JerseySwatch::Mounting::free), exact_(points()), convex_(points()) {
    jersey_.evaluate();
    assemble();
  }

  int points() const { return static_cast<int>(jersey_.state().q.cols()); }
  const Stiffness& exact() const { return exact_; }
  const Stiffness& convex() const { return convex_; }

  /// Blocks of a block row that are not zero, on average.
  double filled() const {
    long count = 0;
    for (int i = 0; i < points(); ++i)
      for (const Stiffness::Entry& entry : exact().row(i)) count += !exact().at(entry.slot).isZero(0);
    return static_cast<double>(count) / points();
  }

  double evaluate() { return jersey_.evaluate(); }
  void assemble() {
    Load load{.stiffness = &exact_, .convex = &convex_};
    jersey_.world().evaluate(jersey_.state(), load);
  }

 private:
  JerseySwatch jersey_;
  Stiffness exact_, convex_;
};

/// Arguments: wales, courses, threads.
Swatch& swatch(benchmark::State& state) {
  static std::map<std::pair<int, int>, Swatch> made;
  omp_set_num_threads(static_cast<int>(state.range(2)));
  const std::pair size{static_cast<int>(state.range(0)), static_cast<int>(state.range(1))};
  Swatch& of = made.try_emplace(size, size.first, size.second).first->second;
  state.counters["unknowns"] = 3 * of.points();
  state.counters["blocks_a_row"] = of.filled();
  return of;
}

void evaluate_forces(benchmark::State& state) {
  Swatch& of = swatch(state);
  for (auto _ : state) benchmark::DoNotOptimize(of.evaluate());
}

void assemble_stiffness(benchmark::State& state) {
  Swatch& of = swatch(state);
  for (auto _ : state) of.assemble();
}

/// The first factor, which finds the order of elimination.
void order_and_factor(benchmark::State& state) {
  const Swatch& of = swatch(state);
  for (auto _ : state) {
    Cholesky cholesky;
    if (!cholesky.factor(of.convex(), shift)) return state.SkipWithError("not positive definite");
  }
}

void factor(benchmark::State& state) {
  const Swatch& of = swatch(state);
  Cholesky cholesky;
  for (auto _ : state)
    if (!cholesky.factor(of.convex(), shift)) return state.SkipWithError("not positive definite");
}

/// One step of conjugate gradients: precondition, multiply.
void iterate(benchmark::State& state) {
  const Swatch& of = swatch(state);
  Cholesky cholesky;
  if (!cholesky.factor(of.convex(), shift)) return state.SkipWithError("not positive definite");
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(3 * of.points(), -1, 1);
  Eigen::VectorXd x, y;
  for (auto _ : state) {
    x = right;
    cholesky.solve(x);
    of.exact().multiply(x, y);
  }
}

void sizes(benchmark::internal::Benchmark* of) {
  of->ArgsProduct({{12}, {13}, {1, 2}})
      ->ArgsProduct({{41}, {40}, {1, 2}})
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}
BENCHMARK(evaluate_forces)->Apply(sizes);
BENCHMARK(assemble_stiffness)->Apply(sizes);
BENCHMARK(order_and_factor)->Apply(sizes);
BENCHMARK(factor)->Apply(sizes);
BENCHMARK(iterate)->Apply(sizes);

}  // namespace
}  // namespace wale
