#include "studio/accuracy/common_rest.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "studio/accuracy/adjust.hpp"
#include "studio/accuracy/along_yarn.hpp"

namespace wale {
namespace {

std::optional<int> resting_stage(const Scene& scene) {
  const auto grips = std::find_if(scene.stages.begin(), scene.stages.end(), std::mem_fn(&Stage::grips));
  if (grips == scene.stages.begin() || grips == scene.stages.end()) return std::nullopt;
  const Stage& before = *(grips - 1);
  if (before.tighten || !before.shrink.empty()) return std::nullopt;
  return static_cast<int>(grips - scene.stages.begin()) - 1;
}

/// With friction a fabric stops where it was held, and there is nothing to find in other segments.
bool rubs(const Stage& stage) { return find_effect<Friction>(stage) != nullptr; }

double knitted_length(const Fabric& fabric, const Yarn& yarn) {
  double sum = 0;
  for (int i = 0; i < yarn.segments; ++i) sum += fabric.segment(yarn.first_segment + i).knitted;
  return sum;
}

bool same_yarns(const Fabric& a, const Fabric& b) {
  constexpr double tolerance = 0.01;  // ends and joins are measured along other polygons
  return std::equal(a.yarns.begin(), a.yarns.end(), b.yarns.begin(), b.yarns.end(),
                    [&](const Yarn& one, const Yarn& other) {
                      return std::abs(knitted_length(a, one) / knitted_length(b, other) - 1) < tolerance;
                    });
}

}  // namespace

std::optional<Rest> rest_of(const Results& results) {
  const std::optional<int> stage = resting_stage(results.scene);
  if (!stage) return std::nullopt;
  const auto last = std::find_if(results.snapshots.rbegin(), results.snapshots.rend(),
                                 [&](const Snapshot& snapshot) { return snapshot.stage == *stage; });
  const Stage& resting = results.scene.stages[static_cast<std::size_t>(*stage)];
  if (last == results.snapshots.rend() || last->sample != resting.samples) return std::nullopt;
  return Rest{results.scene.fabric, last->state.q, rubs(resting)};
}

std::optional<Beginning> begin_at(const Rest& rest, const Scene& scene) {
  const std::optional<int> stage = resting_stage(scene);
  if (!stage || !same_yarns(rest.fabric, scene.fabric)) return std::nullopt;
  State state;
  state.q = resampled(rest.fabric, rest.q, scene.fabric);
  state.v = Points::Zero(3, state.q.cols());
  const bool rests_on = !rubs(scene.stages[static_cast<std::size_t>(*stage)]);
  return Beginning{rests_on ? *stage : *stage + 1, std::move(state)};
}

Found run_from(const std::optional<Rest>& rest, const Scene& scene, RunOptions options) {
  Results results;
  results.scene = scene;
  if (rest) options.begin = begin_at(*rest, scene);
  const Outcome outcome = run(results, options);
  if (outcome == Outcome::finished) return {measured(results), {}};
  return {std::nullopt, outcome == Outcome::interrupted ? "it was interrupted" : results.effort.failure};
}

}  // namespace wale
