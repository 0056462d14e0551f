#include "sim/solvers/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace wale {
namespace {

constexpr double first_shift = 1e-2;      // N/m, soft against a yarn's bending over a loop
constexpr double smallest_shift = 1e-9;   // N/m
constexpr double largest_shift = 1e9;     // N/m
constexpr double furthest_move = 0.3;     // of the diameter, in one iteration
constexpr double share_of_gap = 0.45;     // two yarns that each move this share of their gap still do not meet

double largest_column(const Points& p) { return std::sqrt(p.colwise().squaredNorm().maxCoeff()); }

}  // namespace

Equilibrium::Equilibrium(World& world) : world_(world), stiffness_(static_cast<int>(world.fabric().points.cols())) {
  thickness_ = world.fabric().materials.front().diameter;
  for (const Material& material : world.fabric().materials) thickness_ = std::min(thickness_, material.diameter);
}

double Equilibrium::safe_move() const {
  return thickness_ * std::min(furthest_move, share_of_gap * world_.closest());
}

double Equilibrium::evaluate(const State& at, Points* force, Effort& effort) {
  world_.prepare(at);
  double energy = 0;
  Load load{.energy = &energy, .force = force};
  world_.evaluate(at, load);
  ++effort.evaluations;
  return energy;
}

bool Equilibrium::factor(const State& at, Effort& effort) {
  static const int mode = std::getenv("WALE_EXACT") ? std::atoi(std::getenv("WALE_EXACT")) : 0;
  if (mode) {
    Load load{.stiffness = &stiffness_, .convex = false};
    world_.evaluate(at, load);
    ++effort.factorizations;
    if (cholesky_.factor(stiffness_, shift_)) return true;
  }
  Load load{.stiffness = &stiffness_, .convex = true};
  world_.evaluate(at, load);
  while (shift_ < largest_shift) {
    ++effort.factorizations;
    if (cholesky_.factor(stiffness_, shift_)) return true;
    shift_ *= 10;
  }
  return false;
}

Eigen::VectorXd Equilibrium::direction(const Points& force) const {
  Eigen::VectorXd x = force.reshaped();
  const auto solve = [this](Eigen::VectorXd& v) { cholesky_.solve(v); };
  solve(x);
  if (!world_.constraints().empty()) world_.constraints().project(x, solve);
  return x;
}

Equilibrium::Answer Equilibrium::relax(State& state, double tolerance, int iterations, Effort& effort) {
  const bool talk = std::getenv("WALE_TALK");
  shift_ = first_shift;
  growth_ = 2;
  Points force;
  double energy = evaluate(state, &force, effort);
  if (!std::isfinite(energy)) return Answer::gave_up;
  for (int i = 0; i < iterations; ++i) {
    residual_ = largest_column(force);
    if (residual_ < tolerance) return Answer::found;
    if (!factor(state, effort)) return Answer::gave_up;
    Eigen::VectorXd step = direction(force);
    const double longest = largest_column(step.reshaped(3, step.size() / 3));
    const double scale = std::min(1.0, safe_move() / longest);
    step *= scale;

    State trial = state;
    trial.q += step.reshaped(3, step.size() / 3);
    Points trial_force;
    const double trial_energy = evaluate(trial, &trial_force, effort);
    Eigen::VectorXd curved;
    stiffness_.multiply(step, curved);
    const double promised = step.dot(force.reshaped()) - step.dot(curved) / 2;
    const double gain = (energy - trial_energy) / promised;
    if (talk)
      std::fprintf(stderr, "  %3d E %.9e res %.3e step %.2e scale %.2e shift %.1e gain %.3f gap %.3f\n", i, energy, residual_,
                   longest, scale, shift_, gain, world_.closest());
    if (std::isfinite(trial_energy) && gain > 1e-3) {
      state = std::move(trial);
      force = std::move(trial_force);
      energy = trial_energy;
      shift_ = std::max(smallest_shift, shift_ * std::max(1.0 / 3, 1 - std::pow(2 * std::min(gain, 1.0) - 1, 3)));
      growth_ = 2;
    } else {
      shift_ *= growth_;
      growth_ *= 2;
      world_.prepare(state);
      if (shift_ > largest_shift) return Answer::gave_up;
    }
  }
  return Answer::gave_up;
}

}  // namespace wale
