#include "sim/world.hpp"

#include <algorithm>
#include <limits>

namespace wale {

World::World(const Fabric& fabric, std::vector<EffectSpec> effects, Schedule tightening, State start,
             const std::vector<Clamp>& clamps)
    : fabric_(fabric),
      tightening_(std::move(tightening)),
      start_(std::move(start)),
      parts_{fabric_, tightening_, start_},
      mass_(fabric),
      constraints_(fabric, clamps, start_.q) {
  for (const EffectSpec& spec : effects)
    add(std::visit([this](const auto& effect) { return make(effect, parts_); }, spec));
}

void World::add(std::unique_ptr<Effect> effect) { effects_.push_back(std::move(effect)); }

void World::prepare(const State& state) {
  for (auto& effect : effects_) effect->prepare(state);
}

void World::evaluate(const State& state, Load& out) const {
  if (out.energy) *out.energy = 0;
  if (out.dissipation) *out.dissipation = 0;
  if (out.force) out.force->setZero(3, state.q.cols());
  if (out.stiffness) out.stiffness->clear();
  if (out.damping) out.damping->clear();
  if (out.convex) out.convex->clear();
  for (const auto& effect : effects_) effect->add(state, out);
}

void World::accelerate(const State& state, Points& acceleration) {
  prepare(state);
  Load load{.force = &acceleration};
  evaluate(state, load);
  if (constraints_.empty()) {
    mass_.solve(acceleration);
    return;
  }
  const auto solve = [this](Eigen::VectorXd& x) {
    Points columns = x.reshaped(3, x.size() / 3);
    mass_.solve(columns);
    x = columns.reshaped();
  };
  Eigen::VectorXd x = acceleration.reshaped();
  solve(x);
  constraints_.project(x, solve);
  acceleration = x.reshaped(3, acceleration.cols());
}

double World::closest() const {
  double closest = std::numeric_limits<double>::infinity();
  for (const auto& effect : effects_) closest = std::min(closest, effect->closest());
  return closest;
}

State at_rest(const Fabric& fabric) {
  return {.t = 0, .q = fabric.points, .v = Points::Zero(3, fabric.points.cols()), .step = 0};
}

}  // namespace wale
