#include "sim/solvers/increment.hpp"

namespace wale {
namespace {

constexpr double held_stiffness = 1e3;  // N/m, of what does not move and feels no force: about as stiff as yarn

}  // namespace

Increment::Increment(World& world)
    : world_(world),
      dissipates_(world.dissipates()),
      inertia_(world),
      mass_(world.ties().columns()),
      damping_(world.ties().columns()),
      by_all_(world.ties().columns()) {}

void Increment::begin(const State& lagged, double time, Points from) { begin(lagged, time, std::move(from), {}); }

void Increment::begin(const State& lagged, double time, Points from, Points coasting, const Points& gaining) {
  time_ = time;
  from_ = std::move(from);
  coasting_ = std::move(coasting);
  if (has_inertia() && mass_.slots() == 0) world_.mass().add_to(mass_);
  if (flows()) expect(lagged, gaining);
  lag(lagged);
}

/// Where the step may end.
void Increment::expect(const State& from, const Points& gaining) {
  State end = from;
  end.q = coasting_ + time_ * time_ * gaining;
  end.v = (coasting_ - from_) / time_ + time_ * gaining;
  inertia_.look_at(end);
}

void Increment::prepare(const State& at) {
  damping_is_of_prepared_ = false;
  world_.prepare(at, Acting::elastic);
}

void Increment::lag(const State& lagged) {
  if (!dissipates_) return;
  lagged_ = lagged;
  damping_is_of_prepared_ = false;
  world_.prepare(lagged, Acting::dissipative);
}

/// Where dissipation is looked at, at the velocity that leads to `at`.
State Increment::moving(const State& at) const {
  State state = lagged_;
  state.v = (at.q - from_) / time_;
  return state;
}

void Increment::attend(std::vector<int> points) {
  attended_ = std::move(points);
  std::vector<std::uint8_t> held;
  if (!attended_.empty()) {
    held.assign(static_cast<std::size_t>(world_.ties().columns()), 1);
    for (const int point : attended_) held[static_cast<std::size_t>(point)] = 0;
  }
  world_.hold(held);
  by_all_ = Stiffness(world_.ties().columns());
  if (dissipates_) world_.prepare(lagged_, Acting::dissipative);
}

Points Increment::spread(const Points& move) const {
  if (attended_.empty()) return world_.ties().spread(move);
  Points all = Points::Zero(3, world_.ties().columns());
  all(Eigen::all, attended_) = move;
  return all;
}

Points Increment::push(const State& at) {
  prepare(at);
  Points force;
  Load load{.force = &force};
  world_.evaluate(at, load, Acting::elastic);
  return force;
}

double Increment::value(const State& at, Points* force) {
  prepare(at);
  double energy = 0;
  Load load{.energy = &energy, .force = force};
  world_.evaluate(at, load, Acting::elastic);
  if (dissipates_) {
    double dissipation = 0;
    Points drag;
    Load loss{.force = force ? &drag : nullptr, .dissipation = &dissipation};
    world_.evaluate(moving(at), loss, Acting::dissipative);
    if (force) *force += drag;
    energy += time_ * dissipation;
  }
  if (has_inertia()) {
    const Points acceleration = (at.q - coasting_) / (time_ * time_);
    const Points inertia = inertia_.times(acceleration);
    energy += time_ * time_ / 2 * acceleration.cwiseProduct(inertia).sum();
    if (force) *force -= inertia;
  }
  if (flows()) {
    energy -= (at.q - coasting_).rightCols<2>().cwiseProduct(inertia_.carried()).sum();
    if (force) force->rightCols<2>() += inertia_.carried();
  }
  if (force && moves_in_part()) *force = gather(*force);
  return energy;
}

/// What of a force on all columns acts on what may move.
Points Increment::gather(const Points& force) const {
  if (!attended_.empty()) return force(Eigen::all, attended_);
  Points free = world_.ties().gather(force);
  if (!world_.ties().empty()) free.rightCols<2>().array() *= world_.guide().mobility().array();
  return free;
}

void Increment::second(const State& at, const Leeway& leeway, const Caution& caution, Model model, Stiffness& out) {
  const bool in_part = moves_in_part(), is_exact = model == Model::exact;
  Stiffness& all = in_part ? by_all_ : out;
  all.clear();
  if (dissipates_ && has_inertia()) {
    all.add(damping_at(at), 1 / time_);
  } else if (dissipates_) {
    add_damping(at, caution.secant, all);
    all.scale(1 / time_);
  }
  Load load{.stiffness = is_exact ? &all : nullptr, .convex = is_exact ? nullptr : &all};
  world_.add_to(load, at, Acting::elastic);
  if (has_inertia()) all.add(mass_, 1 / (time_ * time_));
  if (flows()) inertia_.add_to(all, 1 / (time_ * time_));
  if (caution.shift.size() > 0) leeway.add_to(all, caution.shift);
  if (!in_part) return;
  gather(all, out);
  if (is_exact) add_turning(at, out);
}

void Increment::add_damping(const State& at, double secant, Stiffness& out) const {
  Load loss{.damping = &out, .secant = secant};
  world_.add_to(loss, moving(at), Acting::dissipative);
}

/// Of a motion, whose models of one state, and its impulses, all have a part in it.
const Stiffness& Increment::damping_at(const State& at) {
  if (!damping_is_of_prepared_) {
    damping_.clear();
    add_damping(at, 0, damping_);
    damping_is_of_prepared_ = true;
  }
  return damping_;
}

Points Increment::impulse(const Points& a, const Points& b) const {
  Points sum = inertia_.times(a + time_ * b) / (time_ * time_);
  if (dissipates_) {
    Eigen::VectorXd drag;
    damping_.multiply(a.reshaped(), drag);
    sum += drag.reshaped(3, a.cols()) / time_;
  }
  return gather(sum);
}

/// Columns that follow others around an axis are pushed otherwise as the periods turn them.
void Increment::add_turning(const State& at, Stiffness& exact) {
  const Ties& ties = world_.ties();
  if (!ties.turn()) return;
  Points force;
  Load load{.force = &force};
  world_.evaluate(at, load, Acting::elastic);
  if (dissipates_) world_.add_to(load, moving(at), Acting::dissipative);
  ties.add_turning(force, exact);
  hold_periods(exact);
}

/// By what may move; a period that may not is left with a stiffness of its own.
void Increment::gather(const Stiffness& by_all, Stiffness& by_free) const {
  if (!attended_.empty()) {
    by_free.clear();
    by_free.add_part(by_all, attended_);
    return;
  }
  world_.ties().gather(by_all, by_free);
  hold_periods(by_free);
}

void Increment::hold_periods(Stiffness& by_free) const {
  const auto mobility = world_.guide().mobility();
  for (int period = 0; period < 2; ++period)
    for (int axis = 0; axis < 3; ++axis)
      if (mobility(axis, period) == 0) by_free.hold(points() - 2 + period, axis, held_stiffness);
}

}  // namespace wale
