/// What one core can do at most: products and sums, and reading and writing.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

namespace wale {
namespace {

constexpr int chains = 12;  // enough to hide how long one product and sum takes
constexpr int times = 10000;

// Vector types of the compiler: a whole function is built for another instruction set, without a file of its own.
using Four [[gnu::vector_size(32)]] = double;
using Eight [[gnu::vector_size(64)]] = double;

/// The compiler must not see that all chains are the same.
template <class Real>
[[gnu::always_inline]] inline void multiply_and_add(Real* x) {
  Real a = x[0], b = x[1], c = x[2], d = x[3], e = x[4], f = x[5], g = x[6], h = x[7], i = x[8], j = x[9], k = x[10],
       l = x[11];
  const Real by = x[12], plus = x[13];
  for (int n = 0; n < times; ++n) {
    a = a * by + plus, b = b * by + plus, c = c * by + plus, d = d * by + plus;
    e = e * by + plus, f = f * by + plus, g = g * by + plus, h = h * by + plus;
    i = i * by + plus, j = j * by + plus, k = k * by + plus, l = l * by + plus;
  }
  x[0] = ((a + b) + (c + d)) + ((e + f) + (g + h)) + ((i + j) + (k + l));
}

void run_avx2(Four* x) { multiply_and_add(x); }

#if defined(__x86_64__)
[[gnu::target("avx512f,prefer-vector-width=512")]] void run_avx512(Eight* x) { multiply_and_add(x); }
#endif

template <class Real, void (*run)(Real*)>
void peak(benchmark::State& state) {
  Real x[chains + 2] = {};
  benchmark::DoNotOptimize(&x);
  for (auto _ : state) {
    run(x);
    benchmark::ClobberMemory();
  }
  constexpr int lanes = sizeof(Real) / sizeof(double);
  state.counters["flops"] =
      benchmark::Counter(2.0 * lanes * times * chains, benchmark::Counter::kIsIterationInvariantRate);
}

void peak_avx2(benchmark::State& state) { peak<Four, run_avx2>(state); }
BENCHMARK(peak_avx2);

#if defined(__x86_64__)
void peak_avx512(benchmark::State& state) {
  if (!__builtin_cpu_supports("avx512f")) return state.SkipWithError("not on this machine");
  peak<Eight, run_avx512>(state);
}
BENCHMARK(peak_avx512);
#endif

/// x = y + k z on three arrays of so many KiB.
void triad(benchmark::State& state) {
  const auto length = static_cast<std::size_t>(state.range(0)) * 1024 / sizeof(double);
  std::vector<double> x(length), y(length, 1.0), z(length, 2.0);
  for (auto _ : state) {
    for (std::size_t i = 0; i < length; ++i) x[i] = y[i] + 3.0 * z[i];
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<int64_t>(3 * length * sizeof(double)) * state.iterations());
}
BENCHMARK(triad)->Arg(8)->Arg(200)->Arg(2048)->Arg(65536);

}  // namespace
}  // namespace wale
