#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/solvers/equilibrium.hpp"
#include "sim/solvers/whereabouts.hpp"

namespace wale {
namespace {

constexpr double rough = 10;     // times the tolerance
constexpr int most_rounds = 10;  // of iterations at a load that stays

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
    if (state_.step <= 0) state_.step = spec_.first_step > 0 ? spec_.first_step : until - state_.t;
    for (int rounds = 0;;) {
      const double target = until - state_.t <= 1.001 * state_.step ? until : state_.t + state_.step;
      State next = guess(target);
      increment_.begin(next, target - state_.t, state_.q);
      if (balance(next)) return accept(std::move(next), until);
      if (world_.interrupted()) return Progress::stepped;
      ++effort_.rejected;
      if (!load_changes(target)) {
        state_.q = next.q;
        if (++rounds == most_rounds) return fail();
        continue;
      }
      state_.step = (target - state_.t) / 2;
      if (state_.step < spec_.smallest_step) return fail();
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
  State guess(double target) {
    State next = state_;
    next.t = target;
    equilibrium_.follow(next, (target - state_.t) * state_.v);
    if (world_.fabric().cell) world_.guide().lead(next);
    return next;
  }

  /// Where the load stays as it is a shorter step would come no further than this one did.
  bool load_changes(double target) {
    if (increment_.dissipates() || world_.fabric().cell) return true;
    State later = state_;
    later.t = target;
    Points now, then;
    increment_.value(state_, &now);
    increment_.value(later, &then);
    return now != then;
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
    return equilibrium_.relax(next, {.residual = residual}, spec_.iterations, effort_) == Equilibrium::Answer::found;
  }

  Progress accept(State next, double until) {
    const double step = next.t - state_.t;
    next.v = (next.q - state_.q) / step;
    next.step = std::max(state_.step, 1.5 * step);
    before_ = std::move(state_);
    state_ = std::move(next);
    residual_ = equilibrium_.residual();
    ++effort_.accepted;
    return state_.t >= until ? Progress::arrived : Progress::stepped;
  }

  Progress fail() {
    effort_.failure = fmt::format(
        "no equilibrium was found at load parameter {:.6g}: the largest residual force is {:.3g} N, {}; {:.3g} N was "
        "asked for",
        state_.t, equilibrium_.residual(), whereabouts(world_, equilibrium_.worst_point()), tolerance_);
    return Progress::failed;
  }

  QuasiStatic spec_;
  const World& world_;
  Increment increment_;
  Equilibrium equilibrium_;
  State state_, before_;
  double tolerance_;                // N
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
