#include "sim/solvers/sleepers.hpp"

#include <gtest/gtest.h>

#include "sim/solver.hpp"
#include "sim/solvers/even_motion.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"
#include "tests/support/resting_jersey.hpp"
#include "tests/support/solver_runs.hpp"

namespace wale {
namespace {

constexpr double begins = 20e-6, ends = 80e-6;  // s

const RestingJersey& jersey() {
  static const RestingJersey made(8);
  return made;
}

/// Still at first, then at an even speed.
Schedule late() { return Schedule({{0, 0}, {begins, 0}, {ends, 1}}); }

/// Where a motion came to, and what it cost.
struct Motion {
  State state;
  Effort effort;
  double energy = 0;  // J
  Points momentum{};  // by control point, kg m/s
  double share_spared() const { return effort.spared / static_cast<double>(effort.evaluations); }
};

Motion follow(const std::vector<EffectSpec>& others, double sleep, const State& start, double until = ends) {
  const auto world = jersey().world(others);
  Motion motion;
  {
    const auto solver = make(RungeKutta{.relative = 1e-3, .absolute = 1e-6, .sleep = sleep}, *world, start);
    motion.state = run_to(*solver, until);
    motion.effort = solver->effort();
  }
  Load load{.energy = &motion.energy};
  world->prepare(motion.state);
  world->evaluate(motion.state, load);
  motion.energy += world->mass().kinetic_energy(motion.state.v);
  motion.momentum = world->mass().times(motion.state.v);
  return motion;
}

double energy_at_rest() {
  double energy = 0;
  Load load{.energy = &energy};
  const auto world = jersey().world({});
  world->prepare(jersey().state());
  world->evaluate(jersey().state(), load);
  return energy;
}

double yarn_force() {
  const Material& yarn = jersey().fabric().materials[0];
  return yarn.bending_rigidity / (yarn.diameter * yarn.diameter);
}

TEST(Sleepers, AreNotAskedAndChangeNothingWhereEverythingMoves) {
  const OneThread one;
  State start = jersey().state();
  shake(start.v, 1, 1);
  const Motion plain = follow({Drag{}}, 0, start, 5e-6), watched = follow({Drag{}}, 1e-3, start, 5e-6);
  expect_same_bits(plain.state, watched.state);
  EXPECT_EQ(plain.effort.evaluations, watched.effort.evaluations);
  EXPECT_EQ(watched.effort.spared, 0);
}

class Strike : public testing::TestWithParam<bool> {
 protected:
  std::vector<EffectSpec> effects() const {
    if (GetParam()) return {Drag{}, jersey().ball(0.5e-3, late())};
    return {Drag{}, jersey().hook(0.5e-3, late())};
  }
};
INSTANTIATE_TEST_SUITE_P(Sleepers, Strike, testing::Bool(),
                         [](const auto& made) { return made.param ? "ball" : "hook"; });

/// The threshold, as a share of EI/d², bounds what is lost, as a share of the way gone.
TEST_P(Strike, FindsThoseWhoSleepAwakeInTimeAndLosesNothing) {
  const OneThread one;
  const Motion plain = follow(effects(), 0, jersey().state());
  const double moved = largest_motion(plain.state.q, jersey().state().q);
  EXPECT_GT(moved, 1e-5);
  double spared = 1;
  for (const double sleep : {1e-2, 1e-3, 1e-4}) {
    SCOPED_TRACE(sleep);
    const Motion motion = follow(effects(), sleep, jersey().state());
    EXPECT_LT(largest_motion(motion.state.q, plain.state.q), sleep * moved);
    // Who sleeps beside the moving ones takes of their momentum what forces up to the threshold give in that time. The
    // frame takes much as well: it is compared with what moves either way.
    EXPECT_LT((motion.momentum - plain.momentum).rowwise().sum().norm(),
              2 * sleep * plain.momentum.colwise().norm().sum());
    EXPECT_NEAR(motion.energy, plain.energy, sleep * (plain.energy - energy_at_rest()));
    EXPECT_LT(motion.share_spared(), spared);
    spared = motion.share_spared();
  }
  EXPECT_GT(spared, 0.1);
}

TEST(Sleepers, FallAsleepWhereMotionHasDiedAway) {
  const OneThread one;
  State start = jersey().state();
  shake(start.v, 1e-3, 1);
  const std::vector<EffectSpec> thick{Drag{.coefficient = 20}};
  const Motion motion = follow(thick, 1e-2, start);
  EXPECT_GT(motion.share_spared(), 0.5);
  EXPECT_LT(largest_motion(motion.state.q, follow(thick, 0, start).state.q), 1e-4 * 1e-3);
}

TEST(Sleepers, SleepOnInASolverMadeFromTheirState) {
  const OneThread one;
  const std::vector<EffectSpec> effects{Drag{}, jersey().hook(0.5e-3, late())};
  const Motion half = follow(effects, 1e-2, jersey().state(), 60e-6), rest = follow(effects, 1e-2, half.state),
               whole = follow(effects, 1e-2, jersey().state());
  EXPECT_NEAR(rest.effort.spared + half.effort.spared, whole.effort.spared, 0.05 * whole.effort.spared);
  EXPECT_LT(largest_motion(rest.state.q, whole.state.q), 1e-3 * largest_motion(whole.state.q, jersey().state().q));
}

TEST(Sleepers, AreNoneWhereRestLengthsChange) {
  const OneThread one;
  World world(jersey().fabric(), {Stretch{}, Bend{}}, Schedule::ramp(0, 1, 1), jersey().state());
  EXPECT_FALSE(world.may_rest());
  Sleepers sleepers(world, jersey().state(), yarn_force());
  State state = jersey().state();
  EXPECT_FALSE(sleepers.review(state, Points::Zero(3, state.q.cols())));
  EXPECT_EQ(sleepers.share_awake(), 1);
}

}  // namespace
}  // namespace wale
