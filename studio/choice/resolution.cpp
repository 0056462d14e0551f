#include "studio/choice/resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/front/limits.hpp"
#include "studio/accuracy/adjust.hpp"
#include "studio/accuracy/sentences.hpp"

namespace wale {
namespace {

constexpr double longest = 1.2, shortest = 0.2, step = 0.97;  // of the segment lengths that are tried
constexpr double well_known = 0.0075;  // by more a reference would say what another run of it does not
constexpr double none = std::numeric_limits<double>::infinity();
constexpr double share_of_scenes = 0.9;
constexpr double margin = 2.0 / 3;  // of what is asked: scenes are more various than those of a calibration
constexpr int rest_iterations = 1000;
constexpr double rest_tolerance = 0.01;  // over what is asked; see `rest_tolerance` in docs/accuracy.md

/// The next even number of segments that a stitch may have.
int even(double segments) {
  return std::clamp(2 * static_cast<int>(std::ceil(segments / 2)), limits::least_segments, limits::most_segments);
}

/// What is below which in nine of ten scenes.
double nine_of_ten(std::vector<double> errors) {
  const auto count = static_cast<double>(errors.size());
  const auto nth = errors.begin() + static_cast<std::ptrdiff_t>(std::ceil(share_of_scenes * count)) - 1;
  std::nth_element(errors.begin(), nth, errors.end());
  return *nth;
}

/// What was measured at rising numbers of segments, at one between them; of more than the most no better than that, of
/// fewer than the fewest nothing is known.
double at(double segments, const std::vector<int>& measured, const std::vector<double>& values) {
  const auto more = std::lower_bound(measured.begin(), measured.end(), segments);
  if (more == measured.end()) return values.back();
  const auto next = static_cast<std::size_t>(more - measured.begin());
  if (*more == segments) return values[next];
  if (next == 0 || std::isinf(values[next - 1]) || std::isinf(values[next])) return none;
  const double share = std::log(segments / measured[next - 1]) / std::log(double(*more) / measured[next - 1]);
  return values[next - 1] * std::pow(values[next] / values[next - 1], share);
}

/// Those whose reference is known to `asked` and to `well_known`; if there are none, all.
std::vector<const Calibration::Scene*> scenes_for(double asked, const Calibration& from) {
  std::vector<const Calibration::Scene*> scenes, all;
  for (const Calibration::Scene& scene : from.scenes) {
    all.push_back(&scene);
    if (scene.reference <= std::min(asked, well_known)) scenes.push_back(&scene);
  }
  return scenes.empty() ? all : scenes;
}

/// The cheaper of two that meet what is aimed at, else the one that does, else the nearer.
bool better(const Resolution& a, const Resolution& b) {
  const auto meets = [](const Resolution& of) { return of.expected <= margin * of.asked; };
  if (meets(a) != meets(b)) return meets(a);
  return meets(a) ? a.cost < b.cost : a.expected < b.expected;
}

/// Times by which samples that strain so much are multiplied so that each strains no more than `most`.
int times_for(double strain_a_sample, double most) {
  constexpr double rounding = 1e-2;
  return strain_a_sample > 0 ? std::max(1, static_cast<int>(std::ceil(strain_a_sample / most - rounding))) : 1;
}

void set_effects(Stage& stage, const Resolution& to, double diameter) {
  for (EffectSpec& effect : stage.effects) {
    std::visit(
        [&](auto& spec) {
          if constexpr (requires { spec.sampling; }) spec.sampling = to.fineness.sampling;
        },
        effect);
    auto* friction = std::get_if<Friction>(&effect);
    if (friction && strain_path(stage) > 0)
      friction->threshold = to.friction_threshold * strain_path(stage) / stage.duration * diameter;
  }
}

/// Without friction a fabric without end has a rest to find; with it a swatch stops where it is held.
void set_solver(Stage& stage, const Resolution& to, bool periodic) {
  auto* solver = std::get_if<QuasiStatic>(&stage.solver);
  if (!solver) return;
  if (stage.strains()) {
    solver->of_load = to.fineness.tolerance;
    solver->tolerance = to.fineness.tolerance / 2;
    stage.samples *= to.samples_times;
  } else if (periodic && !find_effect<Friction>(stage) && !stage.tighten) {
    solver->tolerance = std::min(solver->tolerance, rest_tolerance * to.asked);
    solver->iterations = std::max(solver->iterations, rest_iterations);
  }
}

}  // namespace

Resolution choose_resolution(double asked, const Scales& scales, double strain_a_sample, const Calibration& from) {
  const std::vector<const Calibration::Scene*> scenes = scenes_for(asked, from);
  Resolution best{.asked = asked, .expected = none, .cost = none};
  for (std::size_t i = 0; i < from.fineness.size(); ++i)
    for (double length = longest; length > shortest; length *= step) {
      Resolution tried{.asked = asked, .segment_length = length, .fineness = from.fineness[i]};
      std::vector<double> errors;
      for (const Calibration::Scene* scene : scenes)
        errors.push_back(at(scene->stitch_length / length, from.segments, scene->errors[i]));
      tried.expected = nine_of_ten(std::move(errors));
      tried.samples_times = times_for(strain_a_sample, tried.fineness.load_step);
      tried.cost = at(scales.stitch_length / scales.diameter / length, from.segments, from.costs[i]);
      if (better(tried, best)) best = tried;
    }
  best.segments_per_stitch = even(scales.stitch_length / scales.diameter / best.segment_length);
  best.friction_threshold = from.friction_threshold;
  best.scenes = static_cast<int>(scenes.size());
  return best;
}

Resolution refined(Resolution of) {
  of.segments_per_stitch = even(1.25 * of.segments_per_stitch);
  of.samples_times *= 2;
  ++of.refinements;
  return of;
}

Variant variant_of(const Resolution& of) {
  Variant variant;
  variant.changes.segments_per_stitch = of.segments_per_stitch;
  variant.adjust = [of](Scene& scene) {
    const double diameter = scales_of(scene.fabric, of.segments_per_stitch).diameter;
    for (Stage& stage : scene.stages) {
      set_solver(stage, of, scene.fabric.cell.has_value());
      set_effects(stage, of, diameter);
    }
  };
  return variant;
}

std::string words_of(const Resolution& of, int written) {
  return fmt::format(
      "For an error of {} of the peak stress:\n"
      "  {} segments a stitch ({} written), contact beads that bulge by {} of a diameter, a residual of {} of the load "
      "on a stitch, {}\n"
      "  in 9 of 10 of {} measured scenes this was off by {} or less{}\n",
      percent(of.asked), of.segments_per_stitch, written, percent(of.fineness.sampling), percent(of.fineness.tolerance),
      of.samples_times == 1 ? std::string("samples as written") : fmt::format("{} times the samples", of.samples_times),
      of.scenes, percent(of.expected), of.reached() ? "" : "; nothing measured reaches what is asked");
}

}  // namespace wale
