/// Measures studio/accuracy/calibration_table.hpp and prints it: jersey, garter, rib and seed, three lengths of
/// stitches, both directions, with each knob turned by itself.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "studio/accuracy/calibration.hpp"
#include "studio/accuracy/study.hpp"

namespace wale {
namespace {

constexpr int segments = 24, samples = 24;
constexpr double none = std::numeric_limits<double>::infinity();  // what a run without an answer is off
constexpr double strain = 0.8, seconds = 8, tolerance = 0.01;
const Material yarn;

struct Case {
  std::string pattern, direction;
  double stitch_length;  // mm
  std::string name() const { return fmt::format("{} of {:g} mm along the {}s", pattern, stitch_length, direction); }
};

std::string text_of(const Case& of) {
  return fmt::format(
      R"(scene: 1
name: {0}
fabric: {{pattern: {1}/patterns/{2}.yaml, wales: 2, courses: 2, periodic: true, stitch_length: {3} mm,
  segments_per_stitch: {4}}}
effects: {{stretch: , bend: , contact: }}
stages:
  - {{name: tighten, duration: 1 s, tighten: 100 %, samples: 4}}
  - {{name: relax, duration: 1 s, samples: 1, solver: {{quasi_static: {{tolerance: 1e-4}}}}}}
  - name: pull
    duration: {5} s
    pull: {{along: {6}, to: {7}}}
    samples: {8}
    effects: {{friction: }}
    solver: {{quasi_static: {{tolerance: {9}, of_load: {10}}}}}
)",
      of.name(), WALE_SOURCE_DIR, of.pattern, of.stitch_length, segments, seconds, of.direction, strain, samples,
      tolerance / 2, tolerance);
}

struct Measurement {
  std::vector<double> errors, costs;
};

/// Measurements by knob and value, the values falling.
using Table = std::map<std::string, std::map<double, Measurement, std::greater<>>>;

/// A rung's size in the units of Calibration.
double value_of(const std::string& knob, double size, const Case& of) {
  if (knob == "segments") return size * of.stitch_length * 1e-3 / yarn.diameter;
  if (knob == "tolerance") return size * tolerance;
  if (knob == "load_step") return size * strain;
  if (knob == "friction_threshold") return size / (strain / seconds * yarn.diameter);
  return size;
}

/// From coarse to fine.
std::vector<Calibrated> measured(const Ladder& ladder, const Case& of) {
  const auto written =
      std::find_if(ladder.trials.begin(), ladder.trials.end(), [](auto& trial) { return trial.as_written; });
  std::vector<Calibrated> found;
  for (const Trial& trial : ladder.trials) {
    const bool lost = !trial.found || trial.rests_elsewhere || !std::isfinite(trial.own_error[of_stress]);
    found.push_back({value_of(ladder.key, trial.size, of), lost ? none : trial.own_error[of_stress],
                     trial.cost.processor / written->cost.processor});
  }
  return found;
}

/// Stitches of other lengths have other segments: at the same lengths of them, between those that ran, powers.
std::vector<Calibrated> at_common_lengths(const std::vector<Calibrated>& ran) {
  std::vector<Calibrated> found;
  for (const double value : {1.1, 0.95, 0.8, 0.7, 0.6, 0.5, 0.42, 0.36, 0.3, 0.25})
    for (std::size_t i = 1; i < ran.size(); ++i) {
      const Calibrated &a = ran[i - 1], &b = ran[i];
      if (value > a.value || value < b.value) continue;
      const double share = std::log(value / a.value) / std::log(b.value / a.value);
      const auto between = [share](double from, double to) {
        return std::isinf(from) || std::isinf(to) ? none : from * std::pow(to / from, share);
      };
      found.push_back({value, between(a.error, b.error), between(a.cost, b.cost)});
      break;
    }
  return found;
}

void add(Table& table, const Ladder& ladder, const Case& of) {
  std::vector<Calibrated> found = measured(ladder, of);
  if (ladder.key == "segments") found = at_common_lengths(found);
  for (const Calibrated& each : found) {
    table[ladder.key][each.value].errors.push_back(each.error);
    table[ladder.key][each.value].costs.push_back(each.cost);
  }
}

/// Of the sorted values the one below which `share` of them lie.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))) - 1;
  return values[std::min(at, values.size() - 1)];
}

void print(const Table& table) {
  for (const auto& [knob, values] : table) {
    fmt::print("\ninline constexpr Calibrated {}[] = {{\n", knob == "segments" ? "segment_length" : knob);
    for (const auto& [value, at] : values)
      fmt::print("    {{{:.3g}, {:.2g}, {:.3g}}},  // median {:.2g}, of {}\n", value, quantile(at.errors, 0.9),
                 quantile(at.costs, 0.5), quantile(at.errors, 0.5), at.errors.size());
    fmt::print("}};\n");
  }
}

/// False if the scene has no reference that its own finest runs agree on.
bool measure(const Case& of, Table& table) {
  Sources sources;
  const Source* source = sources.add(of.name() + ".yaml", text_of(of));
  Diagnostics say;
  const auto parsed = parse_scene(*source, say);
  const SceneText text(*source, sources);
  const auto scene = text.compile({}, say);
  std::vector<Knob> knobs = knobs_of(*parsed, *scene, true);
  std::erase_if(knobs, [](const Knob& knob) {
    constexpr std::string_view wanted[] = {"segments", "sampling", "tolerance", "load_step", "friction_threshold"};
    return std::find(std::begin(wanted), std::end(wanted), knob.key) == std::end(wanted);
  });
  const Study done = study(text, of.name(), std::move(knobs), all_together(*parsed), {});
  const double own = done.reference_error[of_stress];
  const bool valid = own < 0.05;
  fmt::print(stderr, "{}: reference {:.2g} %{}\n", of.name(), 100 * own, valid ? "" : ", left out");
  if (!valid) return false;
  for (const Ladder& ladder : done.ladders)
    if (ladder.key != "together") add(table, ladder, of);
  return true;
}

int calibrate() {
  Table table;
  int used = 0, of = 0;
  for (const char* pattern : {"jersey", "garter", "rib_1x1", "seed"})
    for (const char* direction : {"wale", "course"})
      for (const double length : {6.2, 7.23, 9.0}) {
        used += measure({pattern, direction, length}, table) ? 1 : 0;
        ++of;
      }
  fmt::print(
      "/// Measured by bench/accuracy/calibrate.cpp on {} scenes ({} of them without a reference that is known to 5 %, "
      "and\n"
      "/// left out); see calibration.hpp.\n#pragma once\n\n#include \"studio/accuracy/calibration.hpp\"\n\n"
      "namespace wale::calibrated {{\n",
      of, of - used);
  print(table);
  fmt::print("\n}}  // namespace wale::calibrated\n");
  return 0;
}

}  // namespace
}  // namespace wale

int main() { return wale::calibrate(); }
