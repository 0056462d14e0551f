#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "sim/solver.hpp"
#include "sim/solvers/clearance.hpp"
#include "sim/solvers/explicit_stepper.hpp"
#include "sim/solvers/sleepers.hpp"
#include "sim/solvers/step_control.hpp"
#include "sim/solvers/whereabouts.hpp"
#include "sim/world.hpp"

namespace wale {

namespace {

/// Positions, then velocities, of some control points; of all if there are no Sleepers.
void pack(const Points& q, const Points& v, const std::optional<Sleepers>& some, Eigen::VectorXd& y) {
  if (some)
    y << q(Eigen::all, some->awake()).reshaped(), v(Eigen::all, some->awake()).reshaped();
  else
    y << q.reshaped(), v.reshaped();
}

Eigen::VectorXd pack(const State& state, const std::optional<Sleepers>& some) {
  Eigen::VectorXd y(some ? 6 * static_cast<Eigen::Index>(some->awake().size()) : 2 * state.q.size());
  pack(state.q, state.v, some, y);
  return y;
}

void unpack(const Eigen::VectorXd& y, const std::optional<Sleepers>& some, State& state) {
  const Eigen::Index points = y.size() / 6;
  const Eigen::Map<const Points> q(y.data(), 3, points), v(y.data() + 3 * points, 3, points);
  if (some) {
    state.q(Eigen::all, some->awake()) = q;
    state.v(Eigen::all, some->awake()) = v;
  } else {
    state.q = q;
    state.v = v;
  }
}

std::optional<Sleepers> sleepers_of(const RungeKutta& spec, World& world, const State& start) {
  if (spec.sleep == 0) return {};
  return std::make_optional<Sleepers>(world, start, allowed_residual({.tolerance = spec.sleep}, world.fabric()));
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
        sleepers_(sleepers_of(spec, world, state_)),
        f_([this](double t, const Eigen::VectorXd& y, Eigen::VectorXd& rate) { evaluate(t, y, rate); }) {
    begin();
  }
  RungeKuttaSolver(const RungeKuttaSolver&) = delete;
  RungeKuttaSolver& operator=(const RungeKuttaSolver&) = delete;

  Progress advance(double until) override {
    if (state_.t >= until) return Progress::arrived;
    if (sleepers_) review();
    if (world_.fabric().cell && world_.guide().pace(state_, until)) begin();
    if (!stepper_->rate().allFinite()) return fail("the forces are not finite");
    if (!(state_.step > 0)) state_.step = choose_first_step();
    StepTries tries(state_.t, state_.step, until, tableau_.error_order);
    while (!tries.shorter_than(1e-14 * std::abs(state_.t) + std::numeric_limits<double>::min())) {
      stepper_->attempt(tries.to());
      if (tries.keep(attempted_error())) {
        if (const int passing = segment_passing(); passing >= 0) return fail_to_hold(passing);
        accept(tries.step());
        return state_.t >= until ? Progress::arrived : Progress::stepped;
      }
      ++effort_.rejected;
      if (!stepper_->attempted().allFinite()) ++effort_.retries.halved;
    }
    return fail("the time step shrank to nothing");
  }

  const State& state() const override { return state_; }

  State at(double t) const override {
    State result = state_;
    unpack(stepper_->at(t), sleepers_, result);
    result.t = t;
    return result;
  }

  const Effort& effort() const override { return effort_; }

 private:
  void evaluate(double t, const Eigen::VectorXd& y, Eigen::VectorXd& rate) {
    ++effort_.evaluations;
    if (sleepers_) effort_.spared += 1 - sleepers_->share_awake();
    stage_.t = t;
    unpack(y, sleepers_, stage_);
    world_.accelerate(stage_, acceleration_, sleepers_ ? &force_ : nullptr);
    pack(stage_.v, acceleration_, sleepers_, rate);
  }

  void begin() { stepper_.emplace(tableau_, f_, state_.t, pack(state_, sleepers_)); }

  /// Follows other points from here, if some fall asleep or wake.
  void review() {
    if (!sleepers_->review(state_, force_)) return;
    stage_ = state_;
    begin();
    sleepers_->resume(force_);
  }

  double choose_first_step() {
    if (spec_.first_step > 0) return spec_.first_step;
    return first_step(f_, state_.t, stepper_->y(), stepper_->rate(), tableau_.order, tolerance_);
  }

  /// Not a number if the attempted step is not finite, whatever its estimate. What sleeps makes no error.
  double attempted_error() const {
    if (!stepper_->attempted().allFinite()) return std::numeric_limits<double>::quiet_NaN();
    const double error = scaled_error(stepper_->attempted(), stepper_->error(), tolerance_);
    return sleepers_ ? error * std::sqrt(sleepers_->share_awake()) : error;
  }

  /// A segment of a pair that the attempted step, whose end is the last that was prepared, leads through each other; -1
  /// if none.
  int segment_passing() const {
    if (!(world_.closest() < 0.5)) return -1;
    State next = state_;
    unpack(stepper_->attempted(), sleepers_, next);
    return about_to_pass(world_.fabric(), state_.q, next.q, world_.gaps());
  }

  Progress fail_to_hold(int segment) {
    effort_.failure = fmt::format(
        "two yarns are about to pass through each other at t = {:.6g} s, {}: contact cannot bear the load, and with a "
        "finer sampling bears more",
        state_.t, whereabouts(world_, world_.ties().free_column(world_.fabric().first_point(segment) + 1)));
    return Progress::failed;
  }

  void accept(double next) {
    stepper_->accept();
    unpack(stepper_->y(), sleepers_, state_);
    state_.t = stepper_->t();
    state_.step = next;
    ++effort_.accepted;
  }

  /// Names where the last accepted positions bear the largest force, or one that is not finite, when the step fails.
  Progress fail(const char* why) {
    State at = state_;
    at.t = stage_.t;
    world_.accelerate(at, acceleration_, &force_);
    effort_.failure = fmt::format("{} at t = {:.6g} s, {}", why, state_.t,
                                  whereabouts(world_, world_.ties().free_column(worst_column(force_))));
    return Progress::failed;
  }

  RungeKutta spec_;
  const Tableau& tableau_;
  Tolerance tolerance_;
  World& world_;
  State state_, stage_;
  Points acceleration_;
  Points force_;  // as last evaluated, if somebody may sleep, and where it ends
  std::optional<Sleepers> sleepers_;
  Effort effort_;
  RateFunction f_;
  std::optional<ExplicitStepper> stepper_;
};

}  // namespace

std::unique_ptr<Solver> make(const RungeKutta& spec, World& world, State state) {
  return std::make_unique<RungeKuttaSolver>(spec, world, std::move(state));
}

}  // namespace wale
