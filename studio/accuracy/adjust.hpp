/// Changes to a compiled scene that a study of accuracy makes.
#pragma once

#include <variant>

#include "sim/scene.hpp"

namespace wale {

enum class StageKind : std::uint8_t {
  strained,  ///< mounts, pulls or deforms
  at_rest    ///< all others
};
StageKind kind_of(const Stage&);

/// The last that pulls or deforms; null if there is none.
const Stage* last_strained_stage(const Scene&);

/// The first of that kind; null if there is none.
template <class Effect>
const Effect* find_effect(const Stage& stage) {
  for (const EffectSpec& effect : stage.effects)
    if (const auto* found = std::get_if<Effect>(&effect)) return found;
  return nullptr;
}
/// Likewise in any stage.
template <class Effect>
const Effect* find_effect(const Scene& scene) {
  for (const Stage& stage : scene.stages)
    if (const auto* found = find_effect<Effect>(stage)) return found;
  return nullptr;
}

template <class Effect, class Change>
void for_each_effect(Scene& scene, Change change) {
  for (Stage& stage : scene.stages)
    for (EffectSpec& effect : stage.effects)
      if (auto* found = std::get_if<Effect>(&effect)) change(*found);
}

/// Of every effect that goes by contact beads.
void scale_sampling(Scene&, double factor);
/// Likewise.
void scale_skin(Scene&, double factor);
/// Both tolerances of quasi-static stages of that kind.
void scale_tolerance(Scene&, StageKind, double factor);
/// Of stages that pull or deform quasi-statically; a factor that makes no whole numbers changes nothing.
void scale_samples(Scene&, double factor);
/// Likewise, an odd number rounded up.
void halve_samples(Scene&);
/// Relative and absolute errors of the solvers that follow a motion.
void scale_step_error(Scene&, double factor);
/// Of stages that pull or deform.
void scale_duration(Scene&, double factor);
/// The last pull followed in time: so many seconds long, and damped by the air, without friction.
void pull_in_motion(Scene&, double seconds, const SolverSpec&);
/// Makes the stages of a swatch those of a fabric without end: no grips, no knots, no mount.
void take_edges_off(Scene&);

}  // namespace wale
