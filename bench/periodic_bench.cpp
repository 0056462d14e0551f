/// What the curves of a periodic cell cost, and how near they are to those of a cell twice as fine: 2 x 2 stitches are
/// tightened, relaxed without friction, and from there pulled along the wales and along the courses to 100 %. A fabric
/// may rest in several ways, so the finer cell begins to relax where the other rests; where it rests if left to itself
/// is told as well.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "compiler/compile.hpp"
#include "sim/results/curves.hpp"
#include "sim/run.hpp"
#include "studio/accuracy/common_rest.hpp"

namespace wale {
namespace {

constexpr std::array structures{"jersey", "garter", "rib 1x1", "seed"};

struct Setting {
  int structure = 0, segments = 12;
  int friction = 0;  // coefficient, in hundredths
  int samples = 25;  // of a pull
  auto operator<=>(const Setting&) const = default;
};

Stage stage_of(const Setting& setting) {
  Stage stage;
  stage.effects = {Stretch{}, Bend{}, Contact{}};
  if (setting.friction > 0) stage.effects.push_back(Friction{.coefficient = setting.friction / 100.0});
  return stage;
}

Scene scene_of(const Setting& setting) {
  const std::string stitch = structures[static_cast<std::size_t>(setting.structure)];
  const Source chart{"chart.yaml", "knit: 1\nwales: 2\nbands: [{stitch: " + stitch + ", courses: 2}]\n"};
  ChartOverrides overrides;
  overrides.periodic = true;
  Diagnostics say;
  auto made = compile_chart(chart, overrides, setting.segments, say);
  if (!made) throw std::runtime_error("the chart was refused");
  Scene scene;
  scene.fabric = std::move(made->fabric);
  scene.gauge = std::move(made->gauge);
  scene.gauge.thickness = 1.048e-3;
  scene.crossings = std::move(made->crossings);
  scene.stages = {stage_of({}), stage_of({})};
  scene.stages[0].tighten = 1;
  scene.stages[0].samples = 10;
  // Friction would leave open where it rests, and a larger tolerance takes saddles for it.
  scene.stages[1].samples = 1;
  scene.stages[1].solver = QuasiStatic{.tolerance = 1e-4};
  return scene;
}

void run_on(Results& results, const RunOptions& options = {}) {
  if (run(results, options) != Outcome::finished) throw std::runtime_error(results.effort.failure);
}

Stage pull_of(const Setting& setting, Along along) {
  Stage pull = stage_of(setting);
  pull.samples = setting.samples;
  pull.solver = QuasiStatic{.tolerance = 0.002};  // rib bears little along its courses
  pull.pull = Pull{along, {1.0}};
  return pull;
}

struct Answer {
  std::array<Curve, 2> curves;  // along the wales, along the courses
  long factors = 0;
  bool intact = true;
  Rest rest;

  void take(const Results& pulled, Along along) {
    curves[along == Along::course] = stress_strain(pulled);
    factors += pulled.effort.factorizations;
    intact = intact && pulled.topology.intact();
  }
};

Answer answer_for(const Setting& setting, const Scene& scene) {
  Results relaxed;
  relaxed.scene = scene;
  run_on(relaxed);
  Answer answer;
  answer.factors = -relaxed.effort.factorizations;  // counted in either pull
  answer.rest = {scene.fabric, relaxed.snapshots.back().state.q};
  for (const Along along : {Along::wale, Along::course}) {
    Results pulled = relaxed;
    pulled.scene.stages.push_back(pull_of(setting, along));
    run_on(pulled);
    answer.take(pulled, along);
  }
  return answer;
}

/// The same from where a coarser cell rests.
Answer answer_from(const Rest& rest, const Setting& setting) {
  Answer answer;
  for (const Along along : {Along::wale, Along::course}) {
    Results pulled;
    pulled.scene = scene_of(setting);
    pulled.scene.stages.push_back(pull_of(setting, along));
    run_on(pulled, {.begin = begin_at(rest, pulled.scene)});
    answer.take(pulled, along);
  }
  return answer;
}

/// What a cell twice as fine answers, from the same rest and left to itself.
struct Reference {
  Answer same_rest, own_rest;
};

const Reference& reference_for(const Setting& setting, const Rest& rest) {
  static std::map<Setting, Reference> known;
  const Setting finer{setting.structure, 2 * setting.segments, setting.friction, 2 * setting.samples};
  const auto found = known.find(finer);
  if (found != known.end()) return found->second;
  return known.emplace(finer, Reference{answer_from(rest, finer), answer_for(finer, scene_of(finer))}).first->second;
}

/// The largest difference of stress at a sample, in percent of the peak.
double error(const Curve& curve, const Curve& fine) {
  const std::size_t step = (fine.stress.size() - 1) / (curve.stress.size() - 1);
  double most = 0, peak = 0;
  for (std::size_t i = 0; i < curve.stress.size(); ++i) {
    most = std::max(most, std::abs(curve.stress[i] - fine.stress[i * step]));
    peak = std::max(peak, std::abs(fine.stress[i * step]));
  }
  return 100 * most / peak;
}

/// Arguments: structure, segments a stitch, friction in hundredths, samples of a pull.
void relax_and_pull(benchmark::State& state) {
  omp_set_num_threads(1);
  const Setting setting{static_cast<int>(state.range(0)), static_cast<int>(state.range(1)),
                        static_cast<int>(state.range(2)), static_cast<int>(state.range(3))};
  state.SetLabel(structures[static_cast<std::size_t>(setting.structure)]);
  const Scene scene = scene_of(setting);
  Answer answer;
  try {
    const Reference& fine = reference_for(setting, answer_for(setting, scene).rest);
    for (auto _ : state) answer = answer_for(setting, scene);
    state.counters["wale_error"] = error(answer.curves[0], fine.same_rest.curves[0]);
    state.counters["course_error"] = error(answer.curves[1], fine.same_rest.curves[1]);
    state.counters["wale_error_own_rest"] = error(answer.curves[0], fine.own_rest.curves[0]);
    state.counters["course_error_own_rest"] = error(answer.curves[1], fine.own_rest.curves[1]);
    state.counters["wale_MPa"] = 1e-6 * answer.curves[0].stress.back();
    state.counters["course_MPa"] = 1e-6 * answer.curves[1].stress.back();
    state.counters["factors"] = static_cast<double>(answer.factors);
    state.counters["intact"] = answer.intact && fine.same_rest.intact;
  } catch (const std::runtime_error& failure) {
    state.SkipWithError(failure.what());
  }
}
BENCHMARK(relax_and_pull)
    ->ArgsProduct({{0, 1, 2, 3}, {8, 12, 16, 24, 32, 36, 40, 48}, {0, 30}, {25, 50, 100}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wale
