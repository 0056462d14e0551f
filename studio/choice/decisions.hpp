/// Which effects a scene calls for, by its own scales.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/scene.hpp"
#include "studio/choice/scales.hpp"

namespace wale {

/// What was decided of one effect in one stage, and by which number.
struct Decision {
  int stage = 0;  ///< its place in Scene::stages
  std::string stage_name;
  bool strained = false;  ///< whether the stage pulls or deforms
  std::string effect;
  bool taken = true;
  std::optional<double> estimate{};  ///< share by which it would change the stress, or the rest if nothing strains
  std::string why;
  std::optional<EffectSpec> left_out{};  ///< what to add to see what it would have changed
  std::optional<double> seen{};          ///< the change when it was added
};

/// Leaves out of the stages whose effects are open what changes the answer by less than a quarter of `accuracy`, and
/// follows in time, by `implicit`, stages whose solver is open and whose fabric moves too fast to be in balance.
/// Estimates are of the size of things, from above where there is a choice; `why` says between what they compare.
std::vector<Decision> decide_effects(Scene&, const Scales&, double accuracy);

/// Left out, but by a tenth of what would have kept it in or more: to be tried once.
bool is_borderline(const Decision&, double accuracy);

/// A line a decision, stage by stage.
std::string words_of(const std::vector<Decision>&);

}  // namespace wale
