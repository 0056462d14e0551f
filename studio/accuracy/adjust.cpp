#include "studio/accuracy/adjust.hpp"

#include <algorithm>
#include <cmath>

namespace wale {
namespace {

template <class... Unwanted>
void leave_out(Stage& stage) {
  std::vector<EffectSpec> kept;
  for (const EffectSpec& effect : stage.effects)
    if (!(std::holds_alternative<Unwanted>(effect) || ...)) kept.push_back(effect);
  stage.effects = std::move(kept);
}

template <class Change>
void for_each_by_beads(Scene& scene, Change change) {
  for_each_effect<Contact>(scene, change);
  for_each_effect<ContactDamping>(scene, change);
  for_each_effect<Friction>(scene, change);
}

bool strains_slowly(const Stage& stage) { return stage.strains() && std::holds_alternative<QuasiStatic>(stage.solver); }

}  // namespace

StageKind kind_of(const Stage& stage) { return stage.grips() ? StageKind::strained : StageKind::at_rest; }

const Stage* last_strained_stage(const Scene& scene) {
  const Stage* last = nullptr;
  for (const Stage& stage : scene.stages)
    if (stage.strains()) last = &stage;
  return last;
}

void scale_sampling(Scene& scene, double factor) {
  for_each_by_beads(scene, [factor](auto& effect) { effect.sampling *= factor; });
}

void scale_skin(Scene& scene, double factor) {
  for_each_by_beads(scene, [factor](auto& effect) { effect.skin *= factor; });
}

void scale_tolerance(Scene& scene, StageKind kind, double factor) {
  for (Stage& stage : scene.stages) {
    auto* solver = std::get_if<QuasiStatic>(&stage.solver);
    if (!solver || kind_of(stage) != kind) continue;
    solver->tolerance *= factor;
    solver->of_load *= factor;
  }
}

void scale_samples(Scene& scene, double factor) {
  for (Stage& stage : scene.stages) {
    const double samples = stage.samples * factor;
    if (strains_slowly(stage) && samples == std::round(samples)) stage.samples = static_cast<int>(samples);
  }
}

void halve_samples(Scene& scene) {
  for (Stage& stage : scene.stages)
    if (strains_slowly(stage)) stage.samples = (stage.samples + 1) / 2;
}

void scale_step_error(Scene& scene, double factor) {
  for (Stage& stage : scene.stages) {
    if (auto* solver = std::get_if<RungeKutta>(&stage.solver)) {
      solver->relative *= factor;
      solver->absolute *= factor;
    } else if (auto* implicit = std::get_if<Implicit>(&stage.solver)) {
      implicit->relative *= factor;
      implicit->absolute *= factor;
      implicit->absolute_speed *= factor;
    }
  }
}

void scale_duration(Scene& scene, double factor) {
  for (Stage& stage : scene.stages)
    if (stage.strains()) stage.duration *= factor;
}

void pull_in_motion(Scene& scene, double seconds, const SolverSpec& solver) {
  const Drag air{0.2};  // lets what rings die away within a millisecond; see docs/solvers.md
  for (Stage& stage : scene.stages) {
    if (!stage.pull) continue;
    stage.duration = seconds;
    stage.solver = solver;
    leave_out<Friction>(stage);
    stage.effects.emplace_back(air);
  }
}

void take_edges_off(Scene& scene) {
  std::erase_if(scene.stages, [](const Stage& stage) { return stage.mount.has_value(); });
  for (Stage& stage : scene.stages) {
    stage.hold = Hold::none;
    leave_out<Knots, Gravity>(stage);
    // What is pulled narrows as it will, and a free period has no motion.
    if (stage.follows_motion()) stage.solver = QuasiStatic{};
    if (!stage.tighten && !stage.strains()) stage.solver = QuasiStatic{.tolerance = 1e-4};
  }
}

}  // namespace wale
