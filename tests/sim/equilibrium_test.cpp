#include "sim/solvers/equilibrium.hpp"

#include <gtest/gtest.h>

#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"

namespace wale {
namespace {

constexpr double step = 1;  // s
constexpr Equilibrium::Goal goal{.residual = 1e-4};
constexpr int iterations = 60;

/// Woven yarns that have come to rest, and would without friction.
class Rest : public testing::Test {
 protected:
  Rest() {
    for (int i = 0; i < 40; ++i) balance();
  }

  Equilibrium::Answer balance() {
    increment_.begin(state_, step, state_.q);
    equilibrium_.forget();
    return equilibrium_.relax(state_, goal, iterations, effort_);
  }

  double largest_force() {
    Points force;
    increment_.value(state_, &force);
    return force.colwise().norm().maxCoeff();
  }

  const OneThread one_;
  const Fabric fabric_ = woven_yarns(16, 48, 2);
  State state_ = at_rest(fabric_);
  World world_{fabric_, {Stretch{}, Bend{}, Contact{}, Friction{}}, Schedule::ramp(0, 1, 1), state_, {}, true};
  Increment increment_{world_};
  Equilibrium equilibrium_{increment_};
  Effort effort_;
};

TEST_F(Rest, IsFound) {
  increment_.begin(state_, step, state_.q);
  EXPECT_LT(largest_force(), goal.residual);
}

/// What friction keeps near is balanced while all else stays: to the bit.
TEST_F(Rest, OfOnePlaceIsFoundThere) {
  const int point = fabric_.yarns[7].first_point + 20;
  state_.q.col(point).z() += 5e-6;
  const State pushed = state_;
  ASSERT_GT(largest_force(), goal.residual);
  ASSERT_EQ(balance(), Equilibrium::Answer::found);
  EXPECT_LT(largest_force(), goal.residual);
  const double diameter = fabric_.materials[0].diameter;
  for (int i = 0; i < state_.q.cols(); ++i) {
    if ((pushed.q.col(i) - pushed.q.col(point)).norm() < 15 * diameter) continue;
    EXPECT_EQ(state_.q.col(i), pushed.q.col(i)) << i;
  }
}

}  // namespace
}  // namespace wale
