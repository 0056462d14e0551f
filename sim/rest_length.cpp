#include "sim/rest_length.hpp"

namespace wale {
namespace {

/// After a stage.
std::vector<double> left_after(const Stage& stage, std::vector<double> left, std::size_t materials) {
  if (stage.shrink.empty()) return left;
  left.resize(materials, 1);
  for (const Shrink& shrink : stage.shrink) {
    if (shrink.materials.empty()) left.assign(materials, 1 - shrink.by);
    for (const int material : shrink.materials) left[static_cast<std::size_t>(material)] = 1 - shrink.by;
  }
  return left;
}

}  // namespace

RestLengths RestSchedules::operator()(double t) const {
  RestLengths now(tightening(t));
  for (const Schedule& of_material : left) now.left.push_back(of_material(t));
  return now;
}

RestSchedules rest_schedules(const Stage& stage, const RestLengths& before, std::size_t materials) {
  RestSchedules of(before.tightness);
  if (stage.tighten) of.tightening = Schedule::ramp(before.tightness, *stage.tighten, stage.duration);
  const std::vector<double> after = left_after(stage, before.left, materials);
  for (std::size_t i = 0; i < after.size(); ++i)
    of.left.push_back(Schedule::ramp(before.left.empty() ? 1 : before.left[i], after[i], stage.duration));
  return of;
}

RestLengths rest_lengths_before(const Scene& scene, int stage) {
  RestLengths rest;
  for (int i = 0; i < stage; ++i) {
    const Stage& done = scene.stages[static_cast<std::size_t>(i)];
    rest.tightness = done.tighten.value_or(rest.tightness);
    rest.left = left_after(done, std::move(rest.left), scene.fabric.materials.size());
  }
  return rest;
}

}  // namespace wale
