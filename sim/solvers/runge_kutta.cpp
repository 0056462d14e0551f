#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "sim/solver.hpp"
#include "sim/solvers/clearance.hpp"
#include "sim/solvers/explicit_stepper.hpp"
#include "sim/solvers/step_control.hpp"
#include "sim/solvers/whereabouts.hpp"
#include "sim/world.hpp"

namespace wale {

namespace {

/// Positions, then velocities.
Eigen::VectorXd pack(const State& state) {
  Eigen::VectorXd y(2 * state.q.size());
  y << state.q.reshaped(), state.v.reshaped();
  return y;
}

void unpack(const Eigen::VectorXd& y, State& state) {
  const Eigen::Index points = y.size() / 6;
  state.q = Eigen::Map<const Points>(y.data(), 3, points);
  state.v = Eigen::Map<const Points>(y.data() + 3 * points, 3, points);
}

class RungeKuttaSolver final : public Solver {
 public:
  RungeKuttaSolver(const RungeKutta& spec, World& world, State start)
      : spec_(spec),
        tableau_(tableau_of(spec.method)),
        tolerance_{spec.relative, spec.absolute},
        world_(world),
        state_(std::move(start)),
        stage_(state_),
        f_([this](double t, const Eigen::VectorXd& y, Eigen::VectorXd& rate) { evaluate(t, y, rate); }),
        stepper_(tableau_, f_, state_.t, pack(state_)) {}
  RungeKuttaSolver(const RungeKuttaSolver&) = delete;
  RungeKuttaSolver& operator=(const RungeKuttaSolver&) = delete;

  Progress advance(double until) override {
    if (state_.t >= until) return Progress::arrived;
    if (!stepper_.rate().allFinite()) return fail("the forces are not finite");
    if (!(state_.step > 0)) state_.step = choose_first_step();
    StepTries tries(state_.t, state_.step, until, tableau_.error_order);
    while (!tries.shorter_than(1e-14 * std::abs(state_.t) + std::numeric_limits<double>::min())) {
      stepper_.attempt(tries.to());
      if (tries.keep(attempted_error())) {
        if (const int passing = segment_passing(); passing >= 0) return fail_to_hold(passing);
        accept(tries.step());
        return state_.t >= until ? Progress::arrived : Progress::stepped;
      }
      ++effort_.rejected;
      if (!stepper_.attempted().allFinite()) ++effort_.retries.halved;
    }
    return fail("the time step shrank to nothing");
  }

  const State& state() const override { return state_; }

  State at(double t) const override {
    State result = state_;
    unpack(stepper_.at(t), result);
    result.t = t;
    return result;
  }

  const Effort& effort() const override { return effort_; }

 private:
  void evaluate(double t, const Eigen::VectorXd& y, Eigen::VectorXd& rate) {
    ++effort_.evaluations;
    stage_.t = t;
    unpack(y, stage_);
    world_.accelerate(stage_, acceleration_);
    rate << stage_.v.reshaped(), acceleration_.reshaped();
  }

  double choose_first_step() {
    if (spec_.first_step > 0) return spec_.first_step;
    return first_step(f_, state_.t, stepper_.y(), stepper_.rate(), tableau_.order, tolerance_);
  }

  /// Not a number if the attempted step is not finite, whatever its estimate.
  double attempted_error() const {
    return stepper_.attempted().allFinite() ? scaled_error(stepper_.attempted(), stepper_.error(), tolerance_)
                                            : std::numeric_limits<double>::quiet_NaN();
  }

  /// A segment of a pair that the attempted step, whose end is the last that was prepared, leads through each other; -1
  /// if none.
  int segment_passing() const {
    if (!(world_.closest() < 0.5)) return -1;
    State next = state_;
    unpack(stepper_.attempted(), next);
    return about_to_pass(world_.fabric(), state_.q, next.q, world_.gaps());
  }

  Progress fail_to_hold(int segment) {
    effort_.failure = fmt::format(
        "two yarns are about to pass through each other at t = {:.6g} s, {}: contact cannot bear the load, and with a "
        "finer sampling bears more",
        state_.t, whereabouts(world_, world_.fabric().first_point(segment) + 1));
    return Progress::failed;
  }

  void accept(double next) {
    stepper_.accept();
    unpack(stepper_.y(), state_);
    state_.t = stepper_.t();
    state_.step = next;
    ++effort_.accepted;
  }

  Progress fail(const char* why) {
    effort_.failure = fmt::format("{} at t = {:.6g} s", why, state_.t);
    return Progress::failed;
  }

  RungeKutta spec_;
  const Tableau& tableau_;
  Tolerance tolerance_;
  World& world_;
  State state_, stage_;
  Points acceleration_;
  Effort effort_;
  RateFunction f_;
  ExplicitStepper stepper_;
};

}  // namespace

std::unique_ptr<Solver> make(const RungeKutta& spec, World& world, State state) {
  return std::make_unique<RungeKuttaSolver>(spec, world, std::move(state));
}

}  // namespace wale
