#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "studio/accuracy/report.hpp"

namespace wale {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// As RFC 4180 has it: labels may hold commas.
std::string quoted(std::string_view text) { return fmt::format("\"{}\"", text); }

std::string number(double value) { return std::isnan(value) ? "nan" : fmt::format("{:.9g}", value); }

double greatest_stress(const Measured& of) {
  double most = unknown;
  for (const LabelledCurve& each : of.curves)
    for (const double stress : each.curve.stress) most = std::fmax(most, stress);
  return most;
}

std::string row(const Ladder& ladder, const Trial& trial) {
  const Cost& cost = trial.cost;
  std::string text =
      fmt::format("{},{},{:.9g},{:.6g},{:.6g},{},{},{:.6g},{},{},{}", quoted(ladder.key), quoted(trial.label),
                  trial.size, cost.wall, cost.processor, cost.evaluations, cost.factorizations, cost.memory,
                  trial.found ? static_cast<int>(trial.found->intact) : 0, static_cast<int>(trial.finds_another_rest),
                  static_cast<int>(trial.rests_elsewhere));
  const Measured of = trial.found.value_or(Measured{});
  const auto known = [&](double value) { return number(trial.found ? value : unknown); };
  for (const double value : {greatest_stress(of), of.features.initial_stiffness, of.features.transition_strain,
                             of.relaxed.course_spacing, of.relaxed.wale_spacing, of.energy})
    text += "," + known(value);
  for (const double error : trial.error) text += "," + number(error);
  for (const double error : trial.own_error) text += "," + number(error);
  return text + "\n";
}

}  // namespace

std::string accuracy_csv(const Study& study) {
  std::string text =
      "knob,value,size,wall_s,processor_s,evaluations,factorizations,memory_MB,intact,finds_another_rest,rests_"
      "elsewhere,"
      "greatest_stress_Pa,initial_stiffness_Pa,transition_strain,course_spacing_m,wale_spacing_m,stitch_energy_J";
  for (const std::string_view reading : readings) text += fmt::format(",error_{}", reading);
  for (const std::string_view reading : readings) text += fmt::format(",own_error_{}", reading);
  text += "\n";
  for (const Ladder& ladder : study.ladders)
    for (const Trial& trial : ladder.trials) text += row(ladder, trial);
  return text;
}

}  // namespace wale
