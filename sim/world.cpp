#include "sim/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/effects/beads.hpp"
#include "sim/tile.hpp"

namespace wale {
namespace {

bool is_meant(const Effect& effect, Acting which) {
  return which == Acting::all || effect.dissipative() == (which == Acting::dissipative);
}

}  // namespace

World::World(const Fabric& fabric, std::vector<EffectSpec> effects, RestSchedules rest, State start,
             const std::vector<Clamp>& clamps, bool lagged)
    : fabric_(fabric),
      rest_(std::move(rest)),
      start_(std::move(start)),
      parts_{.fabric = fabric_, .rest = rest_, .start = start_, .lagged = lagged},
      ties_(fabric),
      mass_(fabric),
      period_inertia_(fabric),
      constraints_(fabric, clamps, start_.q) {
  if (fabric.cell && fabric.cell->may_curl()) {
    const Points masses = mass_.times(Points::Ones(3, start_.q.cols()));
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(masses.cols());
    for (int i = 0; i < masses.cols(); ++i) weights[ties_.leader(i)] += masses(0, i);
    mid_surface_.emplace(*fabric.cell, std::move(weights));
  }
  for (const EffectSpec& spec : effects)
    add(std::visit([this](const auto& effect) { return make(effect, parts_); }, spec));
}

void World::add(std::unique_ptr<Effect> effect) { effects_.push_back(std::move(effect)); }

void World::prepare(const State& state, Acting which) {
  for (auto& effect : effects_)
    if (is_meant(*effect, which)) effect->prepare(state);
  if (!mid_surface_ || which == Acting::dissipative) return;
  ties_.look_at(state.q);
  hold_mid_surface(state.q);
}

void World::hold_mid_surface(const Points& q) {
  height_slope_ = ties_.gather(mid_surface_->slope(q));
  Points row = height_slope_;
  row.rightCols<2>().array() *= guide_.mobility().array();
  constraints_.hold_only(row);
}

void World::forget() {
  for (auto* made : {&parts_.made_beads, &parts_.made_lagged_beads})
    for (auto& [setting, beads] : *made) beads->forget_list();
}

Points World::beside_mid_surface(const Points& force) const {
  if (!mid_surface_) return force;
  const auto points = force.cols() - 2;
  const auto by = height_slope_.leftCols(points);
  return force - by.cwiseProduct(force.leftCols(points)).sum() / by.squaredNorm() * height_slope_;
}

bool World::fits_around(const State& state) const {
  if (!mid_surface_) return true;
  const Cylinder on = cylinder(*fabric_.cell, state.q.rightCols<2>());
  const double bent = state.q.rightCols<2>()(on.around, on.around);
  return std::abs(on.curvature * bent) < std::numbers::pi;
}

bool World::dissipates() const {
  return std::any_of(effects_.begin(), effects_.end(), [](const auto& effect) { return effect->dissipative(); });
}

void World::evaluate(const State& state, Load& out, Acting which) const {
  if (out.energy) *out.energy = 0;
  if (out.dissipation) *out.dissipation = 0;
  if (out.force) out.force->setZero(3, state.q.cols());
  if (out.stiffness) out.stiffness->clear();
  if (out.damping) out.damping->clear();
  if (out.convex) out.convex->clear();
  add_to(out, state, which);
}

void World::add_to(Load& out, const State& state, Acting which) const {
  for (const auto& effect : effects_)
    if (is_meant(*effect, which)) effect->add(state, out);
  // An effect may add to one of two that share their pattern.
  for (Stiffness* matrix : {out.stiffness, out.damping, out.convex})
    if (matrix) matrix->fit();
}

bool World::may_rest() const { return rest_.are_constant() && constraints_.empty(); }

void World::hold(const std::vector<std::uint8_t>& held) {
  held_ = held;
  parts_.asleep.clear();
  moving_mass_.reset();
  if (!held.empty()) {
    for (int i = 0; i < fabric_.segment_count(); ++i) {
      const auto first = held.begin() + fabric_.first_point(i);
      parts_.asleep.push_back(std::find(first, first + 4, 0) == first + 4);
    }
    moving_mass_ = mass_.between(held);
  }
  for (auto* made : {&parts_.made_beads, &parts_.made_lagged_beads})
    for (auto& [setting, beads] : *made) beads->leave_out(parts_.asleep);
}

double World::kinetic_energy(const State& state) const {
  if (!fabric_.cell) return mass_.kinetic_energy(state.v);
  return mass_.kinetic_energy(beside_flow(state)) + period_inertia_.kinetic_energy(state, guide_);
}

void World::accelerate(const State& state, Points& acceleration, Points* force) {
  prepare(state);
  Load load{.force = &acceleration};
  evaluate(state, load);
  if (force) *force = acceleration;
  if (moving_mass_) {
    moving_mass_->solve(acceleration);
    for (std::size_t i = 0; i < held_.size(); ++i)
      if (held_[i]) acceleration.col(static_cast<Eigen::Index>(i)).setZero();
    return;
  }
  if (fabric_.cell && guide_.leaves_free()) {
    const Points bears = acceleration;
    mass_.solve(acceleration);
    period_inertia_.add_to(acceleration, bears, state, guide_, mass_);
    return;
  }
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

std::vector<Gap> World::gaps() const {
  std::vector<Gap> gaps;
  for (const auto& effect : effects_) effect->list_gaps(gaps);
  return gaps;
}

State at_rest(const Fabric& fabric) {
  const Points q = fabric.cell ? points_and_periods(fabric) : fabric.points;
  return {.t = 0, .q = q, .v = Points::Zero(3, q.cols()), .step = 0};
}

}  // namespace wale
