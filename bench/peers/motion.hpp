/// The equations of motion as a first-order system, positions before velocities.
#pragma once

#include "sim/world.hpp"

namespace wale::peers {

/// y = (q, v) and y' = (v, M⁻¹ f); keeps working space. `world` must outlive it.
class Motion {
 public:
  Motion(World& world, const State& at) : world_(world), state_(at) {}

  static Eigen::VectorXd pack(const State& state) {
    Eigen::VectorXd y(2 * state.q.size());
    y << state.q.reshaped(), state.v.reshaped();
    return y;
  }
  /// The state at time t, with a step of 0.
  const State& unpack(double t, const Eigen::Ref<const Eigen::VectorXd>& y) {
    const Eigen::Index points = y.size() / 6;
    state_.t = t;
    state_.step = 0;
    state_.q = Eigen::Map<const Points>(y.data(), 3, points);
    state_.v = Eigen::Map<const Points>(y.data() + 3 * points, 3, points);
    return state_;
  }
  /// False where the forces are not finite.
  bool rate(double t, const Eigen::Ref<const Eigen::VectorXd>& y, Eigen::Ref<Eigen::VectorXd> out) {
    ++evaluations_;
    unpack(t, y);
    world_.accelerate(state_, acceleration_);
    out << state_.v.reshaped(), acceleration_.reshaped();
    return acceleration_.allFinite();
  }
  long evaluations() const { return evaluations_; }
  World& world() const { return world_; }

 private:
  World& world_;
  State state_;
  Points acceleration_;
  long evaluations_ = 0;
};

}  // namespace wale::peers
