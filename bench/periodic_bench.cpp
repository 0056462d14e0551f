/// What the curves of a periodic cell cost, and how near they are to those of a cell twice as fine: 2 x 2 stitches are
/// tightened, relaxed without friction, and from there pulled along the wales and along the courses to 100 %.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "compiler/compile.hpp"
#include "sim/results/curves.hpp"
#include "sim/run.hpp"

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

void run_on(Results& results) {
  if (run(results, {}) != Outcome::finished) throw std::runtime_error(results.effort.failure);
}

struct Answer {
  std::array<Curve, 2> curves;  // along the wales, along the courses
  long factors = 0;
  bool intact = true;
};

Answer answer_for(const Setting& setting, const Scene& scene) {
  Results relaxed;
  relaxed.scene = scene;
  run_on(relaxed);
  Answer answer;
  answer.factors = -relaxed.effort.factorizations;  // counted in either pull
  for (const Along along : {Along::wale, Along::course}) {
    Results pulled = relaxed;
    Stage pull = stage_of(setting);
    pull.samples = setting.samples;
    pull.solver = QuasiStatic{.tolerance = 0.002};  // rib bears little along its courses
    pull.pull = Pull{along, {1.0}};
    pulled.scene.stages.push_back(pull);
    run_on(pulled);
    answer.curves[along == Along::course] = stress_strain(pulled);
    answer.factors += pulled.effort.factorizations;
    answer.intact = answer.intact && pulled.topology.intact();
  }
  return answer;
}

const Answer& reference_for(const Setting& setting) {
  static std::map<Setting, Answer> known;
  const auto found = known.find(setting);
  return found != known.end() ? found->second
                              : known.emplace(setting, answer_for(setting, scene_of(setting))).first->second;
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
    const Answer& fine =
        reference_for({setting.structure, 2 * setting.segments, setting.friction, 2 * setting.samples});
    for (auto _ : state) answer = answer_for(setting, scene);
    state.counters["wale_error"] = error(answer.curves[0], fine.curves[0]);
    state.counters["course_error"] = error(answer.curves[1], fine.curves[1]);
    state.counters["wale_MPa"] = 1e-6 * answer.curves[0].stress.back();
    state.counters["course_MPa"] = 1e-6 * answer.curves[1].stress.back();
    state.counters["factors"] = static_cast<double>(answer.factors);
    state.counters["intact"] = answer.intact && fine.intact;
  } catch (const std::runtime_error& failure) {
    state.SkipWithError(failure.what());
  }
}
BENCHMARK(relax_and_pull)
    ->ArgsProduct({{0, 1, 2, 3}, {8, 12, 16, 24, 32, 36, 40, 48}, {0, 30}, {25, 50, 100}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wale
