#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/solvers/clearance.hpp"
#include "sim/solvers/equilibrium.hpp"
#include "sim/solvers/hermite.hpp"
#include "sim/solvers/step_control.hpp"
#include "sim/solvers/whereabouts.hpp"

namespace wale {
namespace {

// TR-BDF2 as a Runge-Kutta method (Hosea & Shampine 1996): the trapezoidal rule to γ h, then a backward difference.
// Rows of stages: 0; d, d; w, w, d. The last is b.
constexpr double gamma = 2 - std::numbers::sqrt2, d = gamma / 2, w = std::numbers::sqrt2 / 4;
// b̂ - b, where b̂ is of order three.
constexpr double error_weights[] = {(1 - 4 * w) / 3, 1.0 / 3, -2 * d / 3};
constexpr int error_order = 2;
// Newton's error that is let pass, over the error that a step may have. Its last move overrates it a hundredfold.
constexpr double share_of_newton = 0.3;
constexpr double most_of_newton = 1e-2;  // of the diameter: too little to pass through a yarn
constexpr double smallest_step = 1e-13;  // s, a thousandth of what explicit methods take for the stiffest yarn

double rms(const Points& x) {
  return std::sqrt(x.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, x.cols())));
}

/// Follows the motion in steps each of which makes two increments least.
class ImplicitSolver final : public Solver {
 public:
  ImplicitSolver(const Implicit& spec, World& world, State start)
      : spec_(spec),
        world_(world),
        increment_(world),
        equilibrium_(increment_),
        state_(std::move(start)),
        before_(state_),
        diameter_(thinnest_diameter(world.fabric())) {}

  Progress advance(double until) override {
    if (state_.t >= until) return Progress::arrived;
    equilibrium_.forget();
    if (world_.fabric().cell && world_.guide().pace(state_, until)) state_.a = {};
    if (state_.a.size() == 0) {
      world_.accelerate(state_, state_.a);
      ++effort_.evaluations;
    }
    begin_ = {state_, state_.a};
    if (!begin_.a.allFinite()) return fail("the forces are not finite", without_force());
    if (!(state_.step > 0)) state_.step = spec_.first_step > 0 ? spec_.first_step : first_step();
    StepTries tries(state_.t, state_.step, until, error_order);
    while (!tries.shorter_than(smallest_step)) {
      const bool found = attempt(tries.to());
      if (world_.interrupted()) return Progress::stepped;
      if (!found) {
        worst_point_ = equilibrium_.worst_point();
        tries.halve();
        ++effort_.retries.halved;
      } else if (tries.keep(scaled_error(tries.to() - state_.t))) {
        accept(tries.step());
        return state_.t >= until ? Progress::arrived : Progress::stepped;
      }
      ++effort_.rejected;
    }
    return fail("the time step shrank to nothing", worst_point_);
  }

  const State& state() const override { return state_; }

  State at(double t) const override {
    const double h = state_.t - before_.t;
    if (h <= 0 || t >= state_.t) return state_;
    const double s = std::max(0.0, (t - before_.t) / h);
    const auto between = [&](const HermiteWeights& weights) {
      return Points(weights.first * before_.q + weights.last * state_.q + weights.first_rate * before_.v +
                    weights.last_rate * state_.v);
    };
    return {.t = t, .q = between(hermite(s, h)), .v = between(hermite_rate(s, h)), .step = state_.step};
  }

  const Effort& effort() const override { return effort_; }

 private:
  /// A stage of the method: where it is, how it moves (in `at`) and how it gains speed. The last stage of a step is the
  /// first of the next: forces at its velocities, which are known as well as the tolerance asks, would turn friction
  /// about wherever that is less well than the threshold.
  struct Motion {
    State at;
    Points a;  // m/s²
  };

  /// Computes both stages of the step to `to`. False if Newton's method does not find one.
  bool attempt(double to) {
    const double h = to - state_.t;
    const State &first = begin_.at, &second = middle_.at;
    const Points on = gamma * h * first.v;
    if (!stage(begin_, state_.t + gamma * h, h, first.q + d * h * first.v, first.v + d * h * begin_.a, on, middle_))
      return false;
    const Points further = h * (1 - gamma) * (first.v + (second.v - first.v) * ((1 + gamma) / (2 * gamma)));
    return stage(middle_, to, h, first.q + w * h * (first.v + second.v), first.v + w * h * (begin_.a + middle_.a),
                 further, end_);
  }

  /// The stage at time `t` is q = `q` + d h v, v = `v` + d h a; `ahead` is about how far it lies from `from`, the stage
  /// before, at which dissipation is looked at.
  bool stage(const Motion& from, double t, double h, const Points& q, const Points& v, const Points& ahead,
             Motion& found) {
    const double time = d * h;
    const Points coasting = q + time * v;
    increment_.begin(from.at, time, q, coasting, from.a);
    found.at = from.at;
    found.at.t = t;
    guess(coasting, ahead, found.at);
    const Equilibrium::Goal goal{.move = newton_error(h)};
    if (equilibrium_.relax(found.at, goal, spec_.iterations, effort_) != Equilibrium::Answer::found) return false;
    found.at.v = (found.at.q - q) / time;
    found.a = (found.at.q - coasting) / (time * time);
    if (world_.fabric().cell) tie(from.at, found);
    return true;
  }

  /// Periods that are not free go on at their rate, and what follows follows: to the last bit, or else rounding adds
  /// up.
  void tie(const State& from, Motion& found) const {
    const Eigen::Matrix<double, 3, 2> free = world_.guide().mobility();
    found.at.v.rightCols<2>() = (free.array() == 0).select(from.v.rightCols<2>(), found.at.v.rightCols<2>());
    found.a.rightCols<2>().array() *= free.array();
    for (Points* of : {&found.at.q, &found.at.v, &found.a}) *of = increment_.spread(world_.ties().pick(*of));
  }

  /// Goes along with the periods that are led, which leads no yarn through another, and leaves of `ahead` what is
  /// beside that.
  void flow(Points& ahead, State& at) const {
    ahead += at.q;
    world_.guide().lead(*world_.fabric().cell, at);
    ahead -= at.q;
    ahead.rightCols<2>().array() *= world_.guide().mobility().array();
  }

  /// Moves `at` by about `ahead`, and all of it together to where it coasts on the whole: then inner forces, which move
  /// no centre of mass, are all that is left to find, and momentum is kept however well they are found.
  void guess(const Points& coasting, Points ahead, State& at) {
    if (world_.fabric().cell) flow(ahead, at);
    const Eigen::Index points = world_.fabric().points.cols();
    if (world_.constraints().empty()) {
      const Points missing = world_.mass().times(increment_.beside_free_periods(coasting - at.q - ahead));
      const double mass = world_.mass().times(Points::Ones(3, missing.cols())).row(0).sum();
      const Vec3 together = missing.rowwise().sum() / mass;
      ahead.leftCols(points).colwise() += together;
      const Vec3 shared = world_.mass().times(ahead).rowwise().sum() / mass;
      at.q.leftCols(points).colwise() += shared;
      ahead.leftCols(points).colwise() -= shared;
    }
    equilibrium_.follow(at, ahead);
  }

  /// How fast it moves, but for the flow of its periods, m/s.
  double speed_of(const State& at) const {
    return world_.fabric().cell ? rms(beside_flow(at).leftCols(world_.fabric().points.cols())) : rms(at.v);
  }
  double allowed_speed(double speed) const { return spec_.absolute_speed + spec_.relative * speed; }
  double allowed_way(double speed, double h) const { return spec_.absolute + spec_.relative * h * speed; }

  double newton_error(double h) const {
    const double speed = speed_of(begin_.at);
    return std::min(share_of_newton * std::min(allowed_way(speed, h), d * h * allowed_speed(speed)),
                    most_of_newton * diameter_);
  }

  /// Multiplies positions and velocities by (I - θJ)⁻¹, with the last factor at hand.
  void damp(Points& q, Points& v, double time) const {
    Eigen::VectorXd x = increment_.impulse(q, v).reshaped();
    equilibrium_.precondition(x);
    const Points damped = increment_.spread(x.reshaped(3, x.size() / 3));
    v = (damped - q) / time;
    q = damped;
  }

  /// At most 1 for a step that may be kept. Stiff motion, which the method damps, is damped in the estimate as well:
  /// the first time in the positions, which then stand in the velocities over the time, so a second time.
  double scaled_error(double h) {
    const auto estimate = [&](const Points& one, const Points& two, const Points& three) {
      return Points(h * (error_weights[0] * one + error_weights[1] * two + error_weights[2] * three));
    };
    Points q = estimate(begin_.at.v, middle_.at.v, end_.at.v), v = estimate(begin_.a, middle_.a, end_.a);
    for (int times = 0; times < 2; ++times) damp(q, v, d * h);
    worst_point_ = world_.ties().free_column(worst_column(v));
    const double speed = std::max(speed_of(begin_.at), speed_of(end_.at));
    return std::max(rms(q) / allowed_way(speed, h), rms(v) / allowed_speed(speed));
  }

  /// Moves nothing by more than a hundredth of the diameter.
  double first_step() const {
    const double near = 0.01 * diameter_;
    return std::min(
        {near / std::max(speed_of(state_), 1e-12), std::sqrt(2 * near / std::max(rms(begin_.a), 1e-12)), 1.0});
  }

  void accept(double next) {
    before_ = std::move(state_);
    state_ = end_.at;
    state_.a = end_.a;
    state_.step = next;
    ++effort_.accepted;
  }

  /// The control point whose force is not finite; its mass spreads that along the acceleration of the whole yarn.
  int without_force() const {
    Points force;
    Load load{.force = &force};
    world_.evaluate(state_, load);
    return world_.ties().free_column(worst_column(force));
  }

  Progress fail(const char* why, int point) {
    effort_.failure = fmt::format("{} at t = {:.6g} s, {}", why, state_.t, whereabouts(world_, point));
    return Progress::failed;
  }

  Implicit spec_;
  World& world_;
  Increment increment_;
  Equilibrium equilibrium_;
  State state_, before_;
  Motion begin_, middle_, end_;
  double diameter_ = 0;  // of the thinnest yarn, m
  int worst_point_ = 0;  // where the last step that was tried went wrong most
  Effort effort_;
};

}  // namespace

std::unique_ptr<Solver> make(const Implicit& spec, World& world, State start) {
  return std::make_unique<ImplicitSolver>(spec, world, std::move(start));
}

}  // namespace wale
