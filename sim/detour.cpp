#include "sim/detour.hpp"

#include <algorithm>

namespace wale {
namespace {

constexpr double softer = 0.1;

void change_law(Material& yarn) {
  if (yarn.law == ContactLaw::barrier)
    yarn.contact_stiffness *= softer;
  else
    yarn.law = ContactLaw::barrier;
}

}  // namespace

std::optional<Scene> by_another_law(const Scene& scene, const Stage& stage) {
  const bool touches = std::any_of(stage.effects.begin(), stage.effects.end(),
                                   [](const EffectSpec& effect) { return std::holds_alternative<Contact>(effect); });
  if (!touches) return std::nullopt;
  Scene other = scene;
  for (Material& yarn : other.fabric.materials) change_law(yarn);
  return other;
}

}  // namespace wale
