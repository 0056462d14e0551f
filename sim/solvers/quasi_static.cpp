#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/solvers/equilibrium.hpp"
#include "sim/solvers/whereabouts.hpp"

namespace wale {
namespace {

constexpr double rough = 10;                                 // times the tolerance
constexpr double well_followed = 0.5, least_followed = 0.1;  // of a step
constexpr double on_the_way = 0.01;  // of the control points, out of balance where the load only passes by
constexpr int most_rounds = 10;      // of iterations at a load that stays
// s, over which inertia holds a fabric back: from where a wave runs a millimetre along a yarn to where nothing is felt.
constexpr double first_creep = 1e-6, last_creep = 1e-3;
// How far neighbours move against each other in a step, over what they may at once, for the next to be as long.
constexpr double well_moved = 2;
constexpr double stretched = 1.25;                       // times a step: what is taken at once
constexpr double least_growth = 0.5, most_growth = 1.5;  // of steps
constexpr int most_failures = 3;                         // before that is given up

/// Equilibrium after equilibrium; its time is the load parameter of the schedules.
/// State::v holds the quasi-static velocity, from which the next equilibrium is guessed.
class QuasiStaticSolver final : public Solver {
 public:
  QuasiStaticSolver(const QuasiStatic& spec, World& world, State start)
      : spec_(spec),
        world_(world),
        increment_(world),
        equilibrium_(increment_),
        state_(std::move(start)),
        before_(state_),
        tolerance_(allowed_residual(spec, world.fabric())) {
    world.prepare(state_);
  }

  Progress advance(double until) override {
    equilibrium_.forget();
    if (state_.step <= 0) state_.step = spec_.first_step > 0 ? spec_.first_step : until - state_.t;
    for (int rounds = 0;;) {
      double target = next_stop(until);
      const bool moves = load_changes(target), changes = moves || increment_.dissipates();
      State next = guess(target, moves);
      target = next.t;
      if (!world_.fits_around(next)) return fail_to_bend(target);
      increment_.begin(next, target - state_.t, state_.q);
      // A fabric without friction forgets how it came, and a few places that still slide would hold up all of it.
      unmet_ = target < until && !increment_.dissipates() ? on_the_way : 0;
      if (balance(next)) return accept(std::move(next), until, moves);
      if (world_.interrupted()) return Progress::stepped;
      ++effort_.rejected;
      if (!changes) {
        state_.q = next.q;
        if (++rounds == most_rounds) return fail();
        ++effort_.retries.continued;
        continue;
      }
      const double shorter = (target - state_.t) / 2;
      if (shorter < spec_.smallest_step) return creep(next) ? accept(std::move(next), until, moves) : fail();
      state_.step = shorter;
      ++effort_.retries.halved;
    }
  }

  const State& state() const override { return state_; }

  State at(double t) const override {
    if (state_.t <= before_.t) return state_;
    State between = state_;
    const double share = (t - before_.t) / (state_.t - before_.t);
    between.t = t;
    between.q = before_.q + share * (state_.q - before_.q);
    return between;
  }

  const Effort& effort() const override { return effort_; }
  std::optional<double> residual() const override { return residual_; }

  bool sharpen(double newtons) override {
    if (state_.t <= before_.t) return false;
    State next = state_;
    const bool found = balance(next, newtons);
    if (!found && !(equilibrium_.residual() < *residual_)) return false;
    next.v = (next.q - before_.q) / (state_.t - before_.t);
    state_ = std::move(next);
    residual_ = equilibrium_.residual();
    return found;
  }

 private:
  /// No crumb is left to the end: two steps that are left are alike, and a little more than one is taken at once.
  double next_stop(double until) const {
    const double left = until - state_.t;
    if (left <= stretched * state_.step) return until;
    return state_.t + (left < 2 * state_.step ? left / 2 : state_.step);
  }

  /// Where the load changes the fabric goes on as it did.
  State guess(double target, bool load_changes) {
    State next = state_;
    next.t = target;
    if (load_changes) {
      const double time = target - state_.t, followed = equilibrium_.follow(next, time * state_.v);
      // A load that goes on where the fabric cannot follow tears at it.
      if (followed < well_followed) next.t = state_.t + std::max(followed, least_followed) * time;
    }
    if (const auto& cell = world_.fabric().cell) world_.guide().lead(*cell, next);
    world_.settle(next);
    return next;
  }

  /// Where the load stays as it is a shorter step would come no further than this one did.
  bool load_changes(double target) {
    if (world_.fabric().cell) return true;
    State later = state_;
    later.t = target;
    return increment_.push(state_) != increment_.push(later);
  }

  /// Another way to the equilibrium at `next.t`, for where Newton's method finds none however short the step: inertia
  /// holds the fabric back less and less. Not tried for a periodic fabric.
  bool creep(State& next) {
    if (world_.fabric().cell) return false;
    ++effort_.retries.damped;
    const double duration = next.t - state_.t;
    next.q = state_.q;
    int failures = 0;
    for (double time = first_creep; time < last_creep && failures < most_failures;) {
      increment_.begin(next, time, next.q, next.q);
      const bool found = balance(next, tolerance_);
      if (world_.interrupted()) return false;
      failures += !found;
      time *= found ? 4 : 0.1;
    }
    increment_.begin(next, duration, state_.q);
    return failures < most_failures && balance(next);
  }

  /// Normal forces of friction are taken from a rough balance at the end of the step: those at its beginning are wrong
  /// by the first order of the step.
  bool balance(State& next) {
    if (increment_.dissipates()) {
      if (!balance(next, rough * tolerance_)) return false;
      increment_.lag(next);
    }
    return balance(next, tolerance_);
  }

  bool balance(State& next, double residual) {
    const Equilibrium::Goal goal{.residual = residual, .unmet = unmet_};
    return equilibrium_.relax(next, goal, spec_.iterations, effort_) == Equilibrium::Answer::found;
  }

  Progress accept(State next, double until, bool load_changes) {
    const double step = next.t - state_.t;
    const double moved = load_changes ? equilibrium_.share_of(next.q - state_.q) : 0;
    const double growth = std::clamp(well_moved / std::max(moved, 1e-300), least_growth, most_growth);
    next.v = (next.q - state_.q) / step;
    next.step = growth < 1 ? growth * step : std::max(state_.step, growth * step);
    before_ = std::move(state_);
    state_ = std::move(next);
    residual_ = equilibrium_.residual();
    ++effort_.accepted;
    return state_.t >= until ? Progress::arrived : Progress::stepped;
  }

  Progress fail_to_bend(double target) {
    effort_.failure = fmt::format(
        "at load parameter {:.6g} a repeat would go half a turn around the axis about which the fabric curls: take a "
        "smaller repeat, or bend it less",
        target);
    return Progress::failed;
  }

  Progress fail() {
    const std::string where = whereabouts(world_, equilibrium_.worst_point());
    if (!std::isfinite(equilibrium_.residual()))
      effort_.failure = fmt::format("the forces are not finite at load parameter {:.6g}, {}", state_.t, where);
    else
      effort_.failure = fmt::format(
          "no equilibrium was found at load parameter {:.6g}: the largest residual force is {:.3g} N, {}; {:.3g} N was "
          "asked for",
          state_.t, equilibrium_.residual(), where, tolerance_);
    return Progress::failed;
  }

  QuasiStatic spec_;
  const World& world_;
  Increment increment_;
  Equilibrium equilibrium_;
  State state_, before_;
  double tolerance_;                // N
  double unmet_ = 0;                // see Equilibrium::Goal
  std::optional<double> residual_;  // of state_, N
  Effort effort_;
};

}  // namespace

double allowed_residual(const QuasiStatic& spec, const Fabric& fabric) {
  const Material& yarn = fabric.materials.front();
  return spec.tolerance * yarn.bending_rigidity / (yarn.diameter * yarn.diameter);
}

std::unique_ptr<Solver> make(const QuasiStatic& spec, World& world, State start) {
  return std::make_unique<QuasiStaticSolver>(spec, world, std::move(start));
}

}  // namespace wale
