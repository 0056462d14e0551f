#include "sim/solvers/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wale {
namespace {

constexpr double furthest_move = 0.3;  // of the diameter, in one iteration
constexpr double share_of_gap = 0.45;  // two yarns that each move this share of their gap still do not meet
// Of the diameter. Beads stand about 0.4 d apart: two yarns whose beads come much nearer than half of that diagonal
// could pass between them unseen.
constexpr double least_gap = 0.3;
// A point pulled by the largest residual and held only by the shift would move so many reaches.
constexpr double reaches_when_free = 5;
constexpr int most_inner = 60;  // conjugate-gradient steps

double furthest(const Eigen::VectorXd& x) {
  return std::sqrt(x.reshaped(3, x.size() / 3).colwise().squaredNorm().maxCoeff());
}

/// How many times `along` leads from `move` to the edge of the trust region, where no point moves further than `reach`.
double steps_to_edge(const Eigen::VectorXd& move, const Eigen::VectorXd& along, double reach) {
  double low = 0, high = reach / std::max(furthest(along), 1e-300);
  while (furthest(move + high * along) < reach) high *= 2;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (furthest(move + middle * along) < reach ? low : high) = middle;
  }
  return low;
}

}  // namespace

Equilibrium::Equilibrium(World& world)
    : world_(world),
      exact_(static_cast<int>(world.fabric().points.cols())),
      convex_(static_cast<int>(world.fabric().points.cols())) {
  thickness_ = world.fabric().materials.front().diameter;
  for (const Material& material : world.fabric().materials) thickness_ = std::min(thickness_, material.diameter);
}

double Equilibrium::safe_move() const { return thickness_ * std::min(furthest_move, share_of_gap * world_.closest()); }

void Equilibrium::release(Points& force) const {
  if (world_.constraints().empty()) return;
  Eigen::VectorXd x = force.reshaped();
  world_.constraints().project(x, [](Eigen::VectorXd&) {});
  force = x.reshaped(3, force.cols());
}

double Equilibrium::evaluate(const State& at, Points* force, Effort& effort) {
  world_.prepare(at);
  double energy = 0;
  Load load{.energy = &energy, .force = force};
  world_.evaluate(at, load);
  ++effort.evaluations;
  if (force) release(*force);
  return energy;
}

bool Equilibrium::factor(const State& at, Effort& effort) {
  Load second{.stiffness = &exact_, .convex = &convex_};
  world_.evaluate(at, second);
  ++effort.factorizations;
  return cholesky_.factor(convex_, shift_);
}

void Equilibrium::precondition(Eigen::VectorXd& x) const {
  const auto solve = [this](Eigen::VectorXd& v) { cholesky_.solve(v); };
  solve(x);
  if (!world_.constraints().empty()) world_.constraints().project(x, solve);
}

Equilibrium::Step Equilibrium::downhill(const Points& force) const {
  Eigen::VectorXd residual = force.reshaped();  // of the model's gradient, with the sign of a force
  Eigen::VectorXd move = Eigen::VectorXd::Zero(residual.size()), bent = move;  // bent = K move
  Eigen::VectorXd z = residual, along, stiff;
  precondition(z);
  along = z;
  double rz = residual.dot(z);
  const double goal = 1e-4 * rz;
  Step step;
  int n = 0;
  for (; n < most_inner && rz > goal && rz > 0; ++n) {
    exact_.multiply(along, stiff);
    stiff += shift_ * along;
    const double curvature = along.dot(stiff);
    double alpha = curvature > 0 ? rz / curvature : std::numeric_limits<double>::infinity();
    if (curvature <= 0 || furthest(move + alpha * along) > reach_) {
      alpha = steps_to_edge(move, along, reach_);
      step.limited = true;
    }
    move += alpha * along;
    bent += alpha * stiff;
    if (step.limited) break;
    residual -= alpha * stiff;
    world_.constraints().project(residual, [](Eigen::VectorXd&) {});
    z = residual;
    precondition(z);
    const double next = residual.dot(z);
    along = z + next / rz * along;
    rz = next;
  }
  step.promised = move.dot(force.reshaped()) - move.dot(bent) / 2;
  step.move = std::move(move);
  return step;
}

Equilibrium::Answer Equilibrium::relax(State& state, double tolerance, int iterations, Effort& effort) {
  Points force;
  double energy = evaluate(state, &force, effort);
  if (!std::isfinite(energy)) return Answer::gave_up;
  reach_ = safe_move();
  bool factored = false;
  for (int i = 0; i < iterations; ++i) {
    residual_ = furthest(force.reshaped());
    if (residual_ < tolerance) return Answer::found;
    if (world_.interrupted()) return Answer::gave_up;
    if (!factored) {
      shift_ = residual_ / (reaches_when_free * safe_move());
      if (!factor(state, effort)) return Answer::gave_up;
      factored = true;
    }
    const Step step = downhill(force);
    State trial = state;
    trial.q += step.move.reshaped(3, step.move.size() / 3);
    Points trial_force;
    const double gap = world_.closest();
    const double trial_energy = evaluate(trial, &trial_force, effort);
    const bool apart = world_.closest() >= std::min(gap, least_gap);
    const double gain = (energy - trial_energy) / step.promised;
    const double length = furthest(step.move);
    // Below the rounding of the energy only the force can tell.
    const bool drowned = step.promised < 1e-12 * std::abs(energy);
    const bool good =
        apart && std::isfinite(trial_energy) && (drowned ? furthest(trial_force.reshaped()) < residual_ : gain > 1e-3);
    if (good) {
      state = std::move(trial);
      force = std::move(trial_force);
      energy = trial_energy;
      factored = false;
    } else {
      world_.prepare(state);
    }
    if (!good)
      reach_ = 0.3 * length;
    else if (gain < 0.25)
      reach_ = 0.6 * length;
    else if (gain > 0.6 && step.limited)
      reach_ *= 2;
    reach_ = std::min(reach_, safe_move());
    if (reach_ < 1e-9 * thickness_) return Answer::gave_up;
  }
  return Answer::gave_up;
}

}  // namespace wale
