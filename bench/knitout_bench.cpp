/// A machine's file, from text to a checked stitch graph, and on to yarns.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <iterator>
#include <random>

#include "compiler/compile.hpp"

namespace wale {
namespace {

/// Knit and purl by the toss of a coin, a transfer for every change.
std::string random_fabric(int operations) {
  constexpr int wales = 200;
  std::mt19937 random(1);
  std::string text = ";!knitout-2\n;;Carriers: 1\n;;Machine: SWG091N2\nin 1\n", beds(wales, 'f');
  const auto out = std::back_inserter(text);
  for (int done = 0, course = 0; done < operations; ++course) {
    for (int i = 0; i < wales; ++i) {
      if (random() % 5) continue;
      const char to = beds[static_cast<std::size_t>(i)] == 'f' ? 'b' : 'f';
      fmt::format_to(out, "xfer {}{} {}{}\n", std::exchange(beds[static_cast<std::size_t>(i)], to), i, to, i);
      ++done;
    }
    for (int k = 0; k < wales; ++k, ++done) {
      const int i = course % 2 ? k : wales - 1 - k;
      fmt::format_to(out, "knit {} {}{} 1\n", course % 2 ? '+' : '-', beds[static_cast<std::size_t>(i)], i);
    }
  }
  return text + "out 1\n";
}

void knit_knitout_text(benchmark::State& state) {
  const Source source{"bench.k", random_fabric(static_cast<int>(state.range(0)))};
  for (auto _ : state) {
    Diagnostics say;
    benchmark::DoNotOptimize(knit_knitout(source, {}, say));
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(knit_knitout_text)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// The same to fitted yarns, every crossing proved; stitches of transfers and tosses alike, 12 segments each.
void draw_knitout_text(benchmark::State& state) {
  const Source source{"bench.k", random_fabric(static_cast<int>(state.range(0)))};
  std::size_t stitches = 0;
  for (auto _ : state) {
    Diagnostics say;
    KnitoutOptions options;
    options.stitch_lengths.otherwise = 7.6e-3;
    const auto compiled = compile_knitout(source, options, {}, 12, say);
    if (!compiled) return state.SkipWithError("the fabric cannot be placed");
    stitches = compiled->graph.loops.size();
  }
  state.counters["stitches"] = static_cast<double>(stitches);
}
BENCHMARK(draw_knitout_text)->Arg(12'000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace wale
