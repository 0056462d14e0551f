/// Measures studio/choice/calibration_table.hpp and prints it: jersey, garter, rib and seed, ten cases each, in many
/// segments and finenesses, and compared with one that is much finer.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "studio/accuracy/adjust.hpp"
#include "studio/accuracy/common_rest.hpp"
#include "studio/accuracy/convergence.hpp"
#include "studio/accuracy/cost.hpp"
#include "studio/accuracy/measured.hpp"
#include "studio/accuracy/variant.hpp"
#include "studio/choice/calibration.hpp"

namespace wale {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();
constexpr double strain = 0.8, seconds = 8;  // on the whole way of each
constexpr double friction_threshold = 0.03;  // smaller is not dearer
constexpr int base = 24;                     // segments with which a scene finds its rest, and whose cost is one
const Material yarn;

struct Case {
  std::string pattern;
  double stitch_length;  // mm
  std::string strains;   // the key of the last stage
  double friction = 0.3;
  std::string name() const {
    return fmt::format("{} of {:g} mm, {}, friction {:g}", pattern, stitch_length, strains, friction);
  }
};

/// Three lengths along the wales and the courses, and what is harder: both at once, there and back, much friction and
/// little.
std::vector<Case> cases_of(const std::string& pattern) {
  std::vector<Case> cases;
  for (const double length : {6.2, 7.23, 9.0})
    for (const char* direction : {"wale", "course"})
      cases.push_back({pattern, length, fmt::format("pull: {{along: {}, to: 80 %}}", direction)});
  cases.push_back({pattern, 7.23, "deform: {wale: 40 %, course: 40 %, shear: held}", 0.2});
  cases.push_back({pattern, 6.7, "pull: {along: course, to: [40 %, 0 %]}"});
  cases.push_back({pattern, 7.23, "pull: {along: course, to: 80 %}", 0.5});
  cases.push_back({pattern, 8.0, "pull: {along: wale, to: 80 %}", 0.1});
  return cases;
}

std::string text_of(const Case& of) {
  return fmt::format(
      R"(scene: 1
fabric: {{pattern: {0}/patterns/{1}.yaml, wales: 2, courses: 2, periodic: true, stitch_length: {2} mm}}
effects: {{stretch: , bend: , contact: }}
stages:
  - {{name: tighten, duration: 1 s, tighten: 100 %, samples: 4}}
  - {{name: relax, duration: 1 s, samples: 1, solver: {{quasi_static: {{tolerance: 1e-4}}}}}}
  - {{name: pull, duration: {3} s, {4}, effects: {{friction: {{coefficient: {5}, threshold: {6} m/s}}}}}}
)",
      WALE_SOURCE_DIR, of.pattern, of.stitch_length, seconds, of.strains, of.friction,
      friction_threshold * strain / seconds * yarn.diameter);
}

/// What one run gave.
struct Ran {
  std::optional<Measured> found{};
  double processor = 0;  // s
};

/// One case, and how it lies at rest.
class Subject {
 public:
  explicit Subject(const Case& of)
      : source_(*sources_.add(of.name() + ".yaml", text_of(of))), text_(source_, sources_) {
    Results results;
    results.scene = compile(base, {0.015, 0.003, strain / 24});
    if (run(results, {}) == Outcome::finished) rest_ = rest_of(results);
  }

  /// From the common rest. `threshold`: of friction, over that of all others.
  Ran operator()(int segments, const Fineness& fineness, double threshold = 1) {
    Scene scene = compile(segments, fineness);
    for_each_effect<Friction>(scene, [&](Friction& friction) { friction.threshold *= threshold; });
    Ran ran;
    ran.processor = cost_of([&] { ran.found = run_from(rest_, scene).measured; }).processor;
    return ran;
  }

 private:
  Scene compile(int segments, const Fineness& fineness) {
    Variant variant;
    variant.changes.segments_per_stitch = segments;
    variant.adjust = [&](Scene& scene) {
      scale_sampling(scene, fineness.sampling / Contact{}.sampling);
      Stage& pull = scene.stages.back();
      pull.samples = static_cast<int>(std::lround(strain / fineness.load_step));
      pull.solver = QuasiStatic{.tolerance = fineness.tolerance / 2, .of_load = fineness.tolerance};
    };
    Diagnostics say;
    return text_.compile(variant, say).value();
  }

  Sources sources_;
  const Source& source_;
  SceneText text_;
  std::optional<Rest> rest_;
};

double error_of(const Ran& run, const Measured& reference) {
  if (!run.found) return none;
  const Errors error = difference(*run.found, reference);
  return rests_apart(error) || !std::isfinite(error[of_stress]) ? none : error[of_stress];
}

/// By Fineness and by segments.
using Costs = std::vector<std::vector<std::vector<double>>>;

void measure(const Case& of, Calibration& calibration, Costs& costs) {
  constexpr int fine = 48, finest = 64;
  Subject subject(of);
  const Fineness exact{0.0075, 1e-3, strain / 96};
  const Ran near = subject(fine, exact, 0.3), reference = subject(finest, exact, 0.3);
  Calibration::Scene scene{of.name(), of.stitch_length * 1e-3 / yarn.diameter, none, {}};
  if (reference.found) scene.reference = error_left(1.0 / fine, 1.0 / finest, error_of(near, *reference.found), 2);
  std::vector<std::vector<double>> times;
  for (const Fineness& fineness : calibration.fineness) {
    scene.errors.emplace_back();
    times.emplace_back();
    for (const int segments : calibration.segments) {
      const Ran run = subject(segments, fineness);
      scene.errors.back().push_back(reference.found ? error_of(run, *reference.found) : none);
      times.back().push_back(run.processor);
    }
  }
  const auto one = std::find(calibration.segments.begin(), calibration.segments.end(), base);
  const double unit = times[0][static_cast<std::size_t>(one - calibration.segments.begin())];
  for (std::size_t i = 0; i < times.size(); ++i)
    for (std::size_t j = 0; j < times[i].size(); ++j) costs[i][j].push_back(times[i][j] / unit);
  fmt::print(stderr, "{}: reference {:.2g} %\n", scene.name, 100 * scene.reference);
  calibration.scenes.push_back(std::move(scene));
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

std::string number(double value) { return std::isinf(value) ? "none" : fmt::format("{:.3g}", value); }

std::string list(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number(value);
  return "{" + text + "}";
}

std::string lists(const std::vector<std::vector<double>>& rows) {
  std::string text;
  for (const std::vector<double>& row : rows) text += list(row) + ",\n";
  return "{" + text + "}";
}

void print(const Calibration& of) {
  fmt::print(
      "/// Printed by bench/accuracy/calibrate.cpp: measure anew rather than edit. `none`: no answer, or another "
      "rest.\n"
      "#pragma once\n\n#include <limits>\n\n#include \"studio/choice/calibration.hpp\"\n\nnamespace wale {{\n\n"
      "inline Calibration measured_calibration() {{\n"
      "constexpr double none = std::numeric_limits<double>::infinity();\n"
      "Calibration of;\nof.friction_threshold = {:g};\nof.segments = {};\nof.fineness = {{\n",
      of.friction_threshold, list({of.segments.begin(), of.segments.end()}));
  for (const Fineness& each : of.fineness)
    fmt::print("{{{:.3g}, {:.3g}, {:.3g}}},\n", each.sampling, each.tolerance, each.load_step);
  fmt::print("}};\nof.costs = {};\nof.scenes = {{\n", lists(of.costs));
  for (const Calibration::Scene& scene : of.scenes)
    fmt::print("{{\"{}\", {:.3g}, {}, {}}},\n", scene.name, scene.stitch_length, number(scene.reference),
               lists(scene.errors));
  fmt::print("}};\nreturn of;\n}}\n\n}}  // namespace wale\n");
}

int calibrate() {
  Calibration calibration;
  calibration.friction_threshold = friction_threshold;
  calibration.segments = {12, 16, 20, 24, 28, 32, 40, 48};
  // What beads and residual may be is not worth a choice: these cost a few percent, and coarser ones err by percents.
  for (const double steps : {12, 24, 48}) calibration.fineness.push_back({0.015, 0.003, strain / steps});
  Costs costs(calibration.fineness.size(), std::vector<std::vector<double>>(calibration.segments.size()));
  for (const char* pattern : {"jersey", "garter", "rib_1x1", "seed"})
    for (const Case& of : cases_of(pattern)) measure(of, calibration, costs);
  for (const auto& row : costs) {
    calibration.costs.emplace_back();
    for (const std::vector<double>& each : row) calibration.costs.back().push_back(median(each));
  }
  print(calibration);
  return 0;
}

}  // namespace
}  // namespace wale

int main() { return wale::calibrate(); }
