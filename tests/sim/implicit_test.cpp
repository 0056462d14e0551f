#include <gtest/gtest.h>

#include "sim/solver.hpp"
#include "sim/spline.hpp"
#include "sim/world.hpp"
#include "tests/support/convergence.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/modes.hpp"
#include "tests/support/one_thread.hpp"
#include "tests/support/poison.hpp"
#include "tests/support/solver_runs.hpp"

namespace wale {
namespace {

/// A yarn pinned at one end swings like a pendulum; a soft one has no fast modes.
struct Swing {
  OneThread one_thread;
  Fabric fabric;
  std::unique_ptr<World> world;
  Swing(double axial_stiffness, double bending_rigidity, const Vec3& gravity,
        const std::vector<EffectSpec>& more = {}) {
    Material soft;
    soft.axial_stiffness = axial_stiffness;
    soft.bending_rigidity = bending_rigidity;
    fabric = straight_rod(0.02, 6, soft);
    std::vector<EffectSpec> effects{Stretch{}, Bend{}, Gravity{gravity}};
    effects.insert(effects.end(), more.begin(), more.end());
    world = std::make_unique<World>(fabric, effects, 0.0, at_rest(fabric), std::vector<Clamp>{{.yarn = 0}}, true);
  }
  State start() const { return at_rest(fabric); }
};

/// Takes a step of any error, and goes no further.
State one_step(World& world, State now, double to) {
  now.step = 0;
  const Implicit any{.relative = 1e-9, .absolute = 1e3, .absolute_speed = 1e3, .first_step = 1e3, .iterations = 200};
  const auto solver = make(any, world, now);
  if (solver->advance(to) != Progress::arrived) throw std::runtime_error(solver->effort().failure);
  return solver->state();
}

State even_steps(World& world, State now, double until, int steps) {
  for (int i = 1; i <= steps; ++i) now = one_step(world, now, until * i / steps);
  return now;
}

State exactly(World& world, const State& start, double until) {
  return run_to(*make(RungeKutta{.relative = 1e-10, .absolute = 1e-13}, world, start), until);
}

double distance(const State& a, const State& b) {
  return std::sqrt((a.q - b.q).squaredNorm() / static_cast<double>(a.q.cols()));
}

TEST(Implicit, IsOfOrderTwo) {
  const Swing of(0.05, 1e-10, {0, -9.81, 0}, {Drag{.coefficient = 1e-4}});
  const double until = 0.02;
  const State exact = exactly(*of.world, of.start(), until);
  const Ladder ladder = climb(until / 64, 4, [&](double h) {
    const State end = even_steps(*of.world, of.start(), until, static_cast<int>(std::lround(until / h)));
    return distance(end, exact) + 1e-3 * (end.v - exact.v).norm();
  });
  EXPECT_NEAR(ladder.order(), 2, 0.15) << ladder.print();
}

/// The axial modes of a yarn at h ω from 1e4 on: after one step nothing is left of them.
TEST(Implicit, DampsStiffMotionInOneStep) {
  const OneThread one_thread;
  const Fabric fabric = straight_rod(0.01, 8);
  World world(fabric, {Stretch{.nodes = 3}}, 0.0, at_rest(fabric), {{.yarn = 0}}, true);
  const double slowest = std::sqrt(squared_frequencies(world, at_rest(fabric)).tail(fabric.points.cols() - 1)[0]);
  State start = at_rest(fabric);
  start.q.row(0) *= 1.001;
  start.v.row(0) = start.q.row(0);
  const auto energy = [&](const State& at) {
    double potential = 0;
    Load load{.energy = &potential};
    world.evaluate(at, load);
    return potential + world.mass().kinetic_energy(at.v);
  };
  const State end = one_step(world, start, 1e4 / slowest);
  EXPECT_LT(energy(end), 1e-6 * energy(start));
}

/// An error of h³ a step is held, so one of h² is left at the end: the power 2/3 of the tolerance.
TEST(Implicit, HasAnErrorThatFollowsItsTolerance) {
  const Swing of(0.05, 1e-10, {0, -9.81, 0});
  const double until = 0.02;
  const State exact = exactly(*of.world, of.start(), until);
  const double way = distance(exact, of.start());
  double before = 1;
  for (const double relative : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const Implicit spec{.relative = relative, .absolute = 1e-3 * relative, .absolute_speed = 0.1 * relative};
    const auto solver = make(spec, *of.world, of.start());
    const double error = distance(run_to(*solver, until), exact) / way;
    EXPECT_LT(error, 0.2 * std::pow(relative, 2.0 / 3));
    EXPECT_LT(error, before);
    before = error;
  }
}

/// Steps hardly depend on how stiff a yarn is against stretch.
TEST(Implicit, IsNotHeldUpByStiffModes) {
  std::vector<long> steps;
  for (const double axial_stiffness : {0.5, 5.0, 68.1}) {
    const Swing of(axial_stiffness, 1e-9, {8.5, -4.9, 0});
    const auto solver = make(Implicit{.relative = 1e-3}, *of.world, of.start());
    run_to(*solver, 0.05);
    steps.push_back(solver->effort().accepted + solver->effort().rejected);
  }
  EXPECT_LT(steps[2], 2 * steps[0]);
}

/// Two yarns that press on each other, with all that dissipates, for the solver as a whole.
struct Scuffle {
  OneThread one_thread;
  Fabric fabric = crossing_yarns(ContactLaw::barrier, 21);
  World world{fabric,
              {Stretch{}, Bend{}, Drag{}, Contact{}, ContactDamping{.tangential = 5, .normal = 40},
               Friction{}},
              Schedule(0.0),
              at_rest(fabric),
              {},
              true};
};

constexpr double duration = 2e-4;  // s

TEST(Implicit, GoesOnFromASavedStateAsIfItHadNeverStopped) {
  Scuffle whole, halves;
  const auto straight = make(Implicit{}, whole.world, at_rest(whole.fabric));
  const auto first = make(Implicit{}, halves.world, at_rest(halves.fabric));
  for (int i = 0; i < 5; ++i) ASSERT_EQ(first->advance(duration), Progress::stepped);
  Scuffle elsewhere;
  const auto second = make(Implicit{}, elsewhere.world, first->state());
  expect_same_bits(run_to(*second, duration), run_to(*straight, duration));
}

TEST(Implicit, FailsWithASentenceThatSaysWhere) {
  for (const double from : {0.0, duration / 2}) {
    Scuffle scuffle;
    scuffle.world.add(std::make_unique<Poison>(from, scuffle.fabric.yarns[1].first_point + 3));
    const auto solver = make(Implicit{}, scuffle.world, at_rest(scuffle.fabric));
    Progress progress = Progress::stepped;
    while (progress == Progress::stepped) progress = solver->advance(duration);
    EXPECT_EQ(progress, Progress::failed);
    EXPECT_TRUE(solver->effort().failure.ends_with(", in segment 8 of yarn 1")) << solver->effort().failure;
    EXPECT_TRUE(solver->state().q.allFinite());
    EXPECT_LE(solver->state().t, from);
  }
}

TEST(Implicit, NeverPassesTheEndItIsGivenAndKeepsItsStepThere) {
  Scuffle scuffle;
  const auto solver = make(Implicit{}, scuffle.world, at_rest(scuffle.fabric));
  Progress progress = Progress::stepped;
  while (progress == Progress::stepped) {
    progress = solver->advance(duration);
    EXPECT_LE(solver->state().t, duration);
  }
  ASSERT_EQ(progress, Progress::arrived);
  const double step = solver->state().step;
  run_to(*solver, duration + 1e-3 * step);
  EXPECT_GE(solver->state().step, step);
}

TEST(Implicit, InterpolatesWithinItsLastStep) {
  const Swing of(0.5, 1e-9, {8.5, -4.9, 0});
  const auto solver = make(Implicit{.relative = 1e-4}, *of.world, of.start());
  for (int i = 0; i < 30; ++i) solver->advance(1);
  const State end = solver->state();
  EXPECT_EQ(solver->at(end.t).q, end.q);
  const double h = 1e-9;
  const State late = solver->at(end.t - h);
  EXPECT_LT((late.q - end.q + h * end.v).norm(), 1e-5 * h * end.v.norm() + 1e-15);
  EXPECT_LT((late.v - end.v).norm(), 1e-3 * end.v.norm());
}

TEST(Implicit, GivesTheSameBitsForTwoThreads) {
  const OneThread guard;
  const Fabric fabric = woven_yarns(6, 24, 3);
  std::vector<State> ends;
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    World world(fabric, {Stretch{}, Bend{}, Contact{}, Friction{}}, 0.0, at_rest(fabric), {}, true);
    const auto solver = make(Implicit{}, world, at_rest(fabric));
    for (int i = 0; i < 3; ++i) ASSERT_EQ(solver->advance(1), Progress::stepped) << solver->effort().failure;
    ends.push_back(solver->state());
  }
  expect_same_bits(ends[0], ends[1]);
}

}  // namespace
}  // namespace wale
