#include "sim/solvers/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "sim/solvers/clearance.hpp"
#include "sim/solvers/even_motion.hpp"
#include "sim/solvers/surroundings.hpp"
#include "sim/solvers/whereabouts.hpp"

namespace wale {
namespace {

// Of the diameter, by a point between two looks at what has come near: from one side of another yarn to the other with
// the least clearance on both.
constexpr double furthest_unseen = 0.1;
constexpr double never_through = 0.5;  // of the diameter: beads so far apart leave no room to slip between
// Of the diameter: how far a point would move that is pulled by the largest residual and held only by Levenberg's
// shift.
constexpr double reach_when_free = 1.5;
constexpr Eigen::Index points_around = 8;  // control points along a yarn
constexpr int most_inner = 60;             // conjugate-gradient steps
// Of the control points: of which so few may be out of balance, and so many be moved for them, on their own.
constexpr double few_places = 0.01, most_moved = 0.3;
constexpr double around_places = 3;  // diameters
constexpr int most_of_places = 60;   // iterations
constexpr int most_rounds = 3;
constexpr int most_corrections = 4;  // with the factor of one step
// Of the energy that a step promised: what it must gain to be taken; below which the model is trusted less; and above
// which it is trusted more.
constexpr double least_gain = 1e-3, poor_gain = 0.25, good_gain = 0.6;

double furthest(const Eigen::VectorXd& x) {
  return std::sqrt(x.reshaped(3, x.size() / 3).colwise().squaredNorm().maxCoeff());
}

}  // namespace

Equilibrium::Equilibrium(Increment& increment)
    : increment_(increment),
      world_(increment.world()),
      second_(increment.points()),
      leeway_(world_.fabric()),
      thickness_(thinnest_diameter(world_.fabric())) {}

double Equilibrium::share(const Eigen::VectorXd& move) const {
  return leeway_.share(increment_.spread(move.reshaped(3, move.size() / 3)));
}

/// How many times `along` leads from `move` to the edge of the trust region.
double Equilibrium::steps_to_edge(const Eigen::VectorXd& move, const Eigen::VectorXd& along) const {
  double low = 0, high = reach_ / std::max(share(along), 1e-300);
  while (share(move + high * along) < reach_) high *= 2;
  for (int i = 0; i < 20; ++i) {
    const double middle = (low + high) / 2;
    (share(move + middle * along) < reach_ ? low : high) = middle;
  }
  return low;
}

double Equilibrium::clearance_at(const State& state) const {
  if (!(world_.closest() < never_through)) return std::isnan(world_.closest()) ? 0 : never_through;
  return clearance(world_.fabric(), state.q, world_.gaps());
}

/// Looks at the yarns on the way as often as something could have come near that was not.
bool Equilibrium::stays_apart(const State& from, const Points& move) {
  const double enough = std::min(clearance_, least_clearance);
  const int looks =
      1 +
      static_cast<int>(std::ceil(uneven_motion_nearby(world_.fabric(), from.q, move) / (furthest_unseen * thickness_)));
  State between = from;
  for (int look = 1; look <= looks; ++look) {
    between.q = from.q + move * (static_cast<double>(look) / looks);
    world_.settle(between);
    if (!world_.fits_around(between)) return false;
    increment_.prepare(between);
    if (!(clearance_at(between) >= enough)) return false;
  }
  return true;
}

void Equilibrium::look_around(const State& state) {
  leeway_.update(state.q, world_.gaps());
  clearance_ = clearance_at(state);
}

double Equilibrium::follow(State& state, const Points& move) {
  increment_.prepare(state);
  look_around(state);
  // What all of a periodic fabric does is in its periods.
  const Points even = world_.fabric().cell ? Points(0 * move) : even_motion(state.q, move), uneven = move - even;
  const double at_once = std::min(1.0, 1 / std::max(leeway_.share(uneven), 1e-300));
  for (double whole = 1; whole > 0.01; whole /= 2)
    for (const double part : {1.0, 0.5, 0.0}) {
      const Points by = whole * (even + part * at_once * uneven);
      const double step = std::min(1.0, 1 / std::max(leeway_.share(by), 1e-300));
      if (stays_apart(state, step * by)) {
        state.q += step * by;
        world_.settle(state);
        return whole * step;
      }
      increment_.prepare(state);
    }
  return 0;
}

void Equilibrium::release(Points& force) const {
  if (world_.constraints().empty()) return;
  Eigen::VectorXd x = force.reshaped();
  world_.constraints().project(x, [](Eigen::VectorXd&) {});
  force = x.reshaped(3, force.cols());
}

double Equilibrium::evaluate(const State& at, Points* force, Effort& effort) {
  const double energy = increment_.value(at, force);
  ++effort.evaluations;
  if (force) release(*force);
  return energy;
}

/// Levenberg's shift holds back a fabric by the largest force that is left in it; on the way, where a few places may go
/// on sliding, each place by the largest around it, or else these would hold back all. Inertia holds what is free as
/// well, and to add to it would give or take momentum.
Eigen::VectorXd Equilibrium::shifts(const Points& force, const Goal& goal) const {
  if (increment_.has_inertia()) return {};
  const Fabric& fabric = world_.fabric();
  const double furthest = reach_when_free * thickness_;
  if (goal.unmet == 0 || fabric.cell)
    return Eigen::VectorXd::Constant(fabric.points.cols() + (fabric.cell ? 2 : 0), residual_ / furthest);
  Eigen::VectorXd shift(force.cols());
  for (const Yarn& yarn : fabric.yarns) {
    const Eigen::VectorXd left = force.middleCols(yarn.first_point, yarn.points()).colwise().norm();
    for (Eigen::Index k = 0; k < left.size(); ++k) {
      const Eigen::Index first = std::max<Eigen::Index>(k - points_around, 0),
                         last = std::min(k + points_around, left.size() - 1);
      shift[yarn.first_point + k] =
          std::max(left.segment(first, last - first + 1).maxCoeff(), goal.residual) / furthest;
    }
  }
  return shift;
}

/// An old factor serves until conjugate gradients have cost as much with it as a new one does. A motion needs that of
/// its own matrix: see precondition().
bool Equilibrium::factor(const Trial& now, const Goal& goal, Effort& effort) {
  const bool serves = !increment_.has_inertia() && inner_ <= cholesky_.solves_a_factor();
  const Increment::Caution caution{shifts(now.force, goal), secant_};
  if (!serves) {
    inner_ = 0;
    ++effort.factorizations;
    increment_.second(now.state, leeway_, caution, Increment::Model::convex, second_);
    if (!cholesky_.factor(second_, 0)) return false;
  }
  // After the other, in its place: the memory of a large matrix is worth more than the time to sum up both at once.
  increment_.second(now.state, leeway_, caution, Increment::Model::exact, second_);
  return true;
}

void Equilibrium::precondition(Eigen::VectorXd& x) const {
  const auto solve = [this](Eigen::VectorXd& v) { cholesky_.solve(v); };
  solve(x);
  if (!world_.constraints().empty()) world_.constraints().project(x, solve);
}

Equilibrium::Step Equilibrium::downhill(const Points& force) {
  Eigen::VectorXd residual = force.reshaped();  // of the model's gradient, with the sign of a force
  Eigen::VectorXd move = Eigen::VectorXd::Zero(residual.size()), bent = move;  // bent = K move
  Eigen::VectorXd z = residual, along, stiff;
  precondition(z);
  along = z;
  double rz = residual.dot(z);
  const double goal = 1e-3 * rz;
  Step step;
  for (int i = 0; i < most_inner && rz > goal && rz > 0; ++i, ++inner_) {
    second_.multiply(along, stiff);
    const double curvature = along.dot(stiff);
    double alpha = curvature > 0 ? rz / curvature : std::numeric_limits<double>::infinity();
    if (curvature <= 0 || share(move + alpha * along) > reach_) {
      alpha = steps_to_edge(move, along);
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

/// `move` from `from`, and what is found there; its energy is infinite if yarns would come too near on the way.
Equilibrium::Trial Equilibrium::attempt(const State& from, const Eigen::VectorXd& move, Effort& effort) {
  Trial trial{from, std::numeric_limits<double>::infinity(), {}};
  const Points by = increment_.spread(move.reshaped(3, move.size() / 3));
  if (!stays_apart(from, by)) return trial;
  trial.state.q += by;
  world_.settle(trial.state);
  trial.energy = evaluate(trial.state, &trial.force, effort);
  return trial;
}

/// A straight step out of a curved valley stretches yarn by the square of its length. The factor at hand takes that out
/// again, for much less than a new one costs.
void Equilibrium::correct(Trial& trial, double tolerance, Effort& effort) {
  for (int i = 0; i < most_corrections; ++i) {
    Eigen::VectorXd move = trial.force.reshaped();
    if (furthest(move) < tolerance) return;
    precondition(move);
    const double too_far = share(move) / reach_;
    if (too_far > 1) move /= too_far;
    Trial next = attempt(trial.state, move, effort);
    if (!(next.energy < trial.energy)) {
      increment_.prepare(trial.state);
      return;
    }
    trial = std::move(next);
  }
}

bool Equilibrium::is_met(const Goal& goal, const Trial& now) const {
  if (residual_ < goal.residual) return true;
  if (goal.unmet <= 0) return false;
  const auto more = (now.force.colwise().squaredNorm().array() >= goal.residual * goal.residual).count();
  // Where yarns are about to be stopped they are not left on their way.
  return static_cast<double>(more) <= goal.unmet * static_cast<double>(now.force.cols()) &&
         clearance_at(now.state) > 2 * least_clearance;
}

/// The control points that are out of balance, if they are few, and what lies around them; else none.
std::vector<int> Equilibrium::places(const Trial& now, const Goal& goal) const {
  std::vector<int> left;
  for (int i = 0; i < now.force.cols(); ++i)
    if (now.force.col(i).norm() > goal.residual) left.push_back(i);
  const auto all = static_cast<double>(now.force.cols());
  if (static_cast<double>(left.size()) > few_places * all) return {};
  return surroundings(now.state.q, left, around_places * thickness_);
}

/// Where few places are out of balance, they and what lies around them are moved while all else stays, for a part of
/// what an iteration of all costs; then what that pushes at their edges as well. Friction keeps that near: without it
/// yarn slides on through all of the fabric. Answers whether there was anything of that.
bool Equilibrium::balance_places(Trial& now, const Goal& goal, Effort& effort) {
  if (is_of_places_ || !increment_.dissipates() || increment_.has_inertia() || world_.fabric().cell ||
      !world_.constraints().empty())
    return false;
  std::vector<int> moved;
  for (int round = 0; round < most_rounds && !world_.interrupted(); ++round) {
    const std::vector<int> next = places(now, goal), before = std::move(moved);
    moved.clear();
    std::set_union(before.begin(), before.end(), next.begin(), next.end(), std::back_inserter(moved));
    if (next.empty() || static_cast<double>(moved.size()) > most_moved * static_cast<double>(now.force.cols()))
      return round > 0;
    increment_.attend(moved);
    Equilibrium of_places(increment_);
    of_places.is_of_places_ = true;
    of_places.relax(now.state, goal, most_of_places, effort);
    increment_.attend({});
    now.energy = evaluate(now.state, &now.force, effort);
  }
  return true;
}

/// Trusts the model as far as a step gained what it had promised; whether that changes the model. A contact that comes
/// to stick or begins to slip gains less, however small the trust region is elsewhere: there secants promise less.
bool Equilibrium::adapt(const Step& step, double gain) {
  const double secant = secant_;
  if (gain < poor_gain && secant_ < 1 && increment_.dissipates() && !increment_.has_inertia()) {
    secant_ = 1;
    return true;
  }
  if (gain > good_gain) secant_ = secant_ > 0.1 ? secant_ / 4 : 0;
  if (gain <= least_gain)
    reach_ = 0.3 * share(step.move);
  else if (gain < poor_gain)
    reach_ = 0.6 * share(step.move);
  else if (gain > good_gain && step.limited)
    reach_ *= 2;
  reach_ = std::min(reach_, 1.0);
  return secant_ != secant;
}

Equilibrium::Answer Equilibrium::relax(State& state, const Goal& goal, int iterations, Effort& effort) {
  Trial now{state, 0, {}};
  now.energy = evaluate(state, &now.force, effort);
  reach_ = 1;
  secant_ = 0;
  bool factored = false, try_places = true;
  for (int i = 0; i < iterations; ++i) {
    worst_point_ = worst_column(now.force);
    residual_ = now.force.col(worst_point_).norm();
    if (!std::isfinite(now.energy) || !now.force.allFinite()) return Answer::gave_up;
    if (is_met(goal, now)) return Answer::found;
    if (world_.interrupted()) return Answer::gave_up;
    if (try_places && balance_places(now, goal, effort)) {
      state = now.state;
      factored = false;
      try_places = false;
      continue;
    }
    if (!factored) {
      look_around(now.state);
      if (!factor(now, goal, effort)) return Answer::gave_up;
      factored = true;
    }
    const Step step = downhill(now.force);
    if (!step.limited && furthest(step.move) < goal.move) {
      state.q += increment_.spread(step.move.reshaped(3, step.move.size() / 3));
      world_.settle(state);
      return Answer::found;
    }
    Trial trial = attempt(now.state, step.move, effort);
    if (std::isfinite(trial.energy)) correct(trial, goal.residual, effort);
    const double gain = (now.energy - trial.energy) / step.promised;
    // Below the rounding of the energy only the force can tell.
    const bool drowned = step.promised < 1e-12 * std::abs(now.energy);
    const bool good =
        std::isfinite(trial.energy) && (drowned ? furthest(trial.force.reshaped()) < residual_ : gain > least_gain);
    if (good) {
      now = std::move(trial);
      state = now.state;
      world_.show(state.q);
      try_places = true;
    } else {
      increment_.prepare(now.state);
    }
    if (adapt(step, good ? std::max(gain, 2 * least_gain) : 0) || good) factored = false;
    if (reach_ < 1e-9) return Answer::gave_up;
  }
  return Answer::gave_up;
}

}  // namespace wale
