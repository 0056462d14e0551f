#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "sim/solver.hpp"
#include "sim/solvers/explicit_stepper.hpp"
#include "sim/solvers/step_control.hpp"
#include "sim/world.hpp"
#include "tests/support/convergence.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"
#include "tests/support/poison.hpp"
#include "tests/support/solver_runs.hpp"

namespace wale {
namespace {

using Eigen::VectorXd;

/// A pendulum that is pushed: nonlinear, and its rate depends on t.
void pendulum(double t, const VectorXd& y, VectorXd& rate) {
  rate.resize(2);
  rate << y[1], -std::sin(y[0]) + 0.5 * std::cos(2 * t);
}

const VectorXd pendulum_start = (VectorXd(2) << 1.2, 0.3).finished();

/// A pair of methods, and what is known of it.
struct Pair {
  RungeKutta::Method method;
  const char* name;
  int order, error_order, evaluations;  // of an accepted step
  int dense_power;                      // of its length, with which the error within a step falls
  int rungs;                            // of halvings, before rounding shows

  const Tableau& tableau() const { return tableau_of(method); }
};

class EveryPair : public testing::TestWithParam<Pair> {
 protected:
  ExplicitStepper at_start() const { return {GetParam().tableau(), pendulum, 0, pendulum_start}; }
};

INSTANTIATE_TEST_SUITE_P(RungeKutta, EveryPair,
                         testing::Values(Pair{RungeKutta::Method::kutta, "kutta", 4, 3, 4, 4, 6},
                                         Pair{RungeKutta::Method::dormand_prince, "dormand_prince", 5, 4, 6, 5, 4}),
                         [](const auto& made) { return made.param.name; });

/// Moves `stepper` on to t in so many even steps.
void walk(ExplicitStepper& stepper, double t, int steps) {
  const double from = stepper.t();
  for (int i = 1; i <= steps; ++i) {
    stepper.attempt(from + (t - from) * i / steps);
    stepper.accept();
  }
}

/// At t = 2, to rounding.
const VectorXd& exact_swing() {
  static const VectorXd y = [] {
    ExplicitStepper stepper(dormand_prince54(), pendulum, 0, pendulum_start);
    walk(stepper, 2, 500);
    return stepper.y();
  }();
  return y;
}

TEST_P(EveryPair, HasATableauWhoseRowsAddUp) {
  const Tableau& table = GetParam().tableau();
  for (std::size_t i = 0; i < table.c.size(); ++i)
    EXPECT_NEAR(std::accumulate(table.a[i].begin(), table.a[i].end(), 0.0), table.c[i], 1e-14);
  EXPECT_NEAR(std::accumulate(table.error.begin(), table.error.end(), 0.0), 0, 1e-15);
  EXPECT_NEAR(std::accumulate(table.dense.begin(), table.dense.end(), 0.0), 0, 1e-14);
}

TEST(RungeKutta, HasTheEmbeddedSolutionsOfTheBooks) {
  const auto embedded = [](const Tableau& table, std::size_t i) {
    return (i < table.a.back().size() ? table.a.back()[i] : 0) - table.error[i];
  };
  const double kutta[] = {1.0 / 12, 1.0 / 2, 1.0 / 4, 0, 1.0 / 6};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(embedded(kutta43(), i), kutta[i], 1e-16);
  const double dormand_prince[] = {5179.0 / 57600, 0,       7571.0 / 16695, 393.0 / 640, -92097.0 / 339200,
                                   187.0 / 2100,   1.0 / 40};
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(embedded(dormand_prince54(), i), dormand_prince[i], 1e-16);
}

TEST_P(EveryPair, HasTheOrderOfItsTableau) {
  const Ladder ladder = climb(0.2, GetParam().rungs, [&](double h) {
    ExplicitStepper stepper = at_start();
    walk(stepper, 2, static_cast<int>(std::lround(2 / h)));
    return (stepper.y() - exact_swing()).norm();
  });
  EXPECT_EQ(GetParam().tableau().order, GetParam().order);
  EXPECT_NEAR(ladder.order(), GetParam().order, 0.1) << ladder.print();
}

TEST_P(EveryPair, EstimatesTheErrorOfASolutionOneOrderLower) {
  const Ladder ladder = climb(0.1, 6, [&](double h) {
    ExplicitStepper stepper = at_start();
    stepper.attempt(h);
    return stepper.error().norm();
  });
  EXPECT_EQ(GetParam().tableau().error_order, GetParam().error_order);
  EXPECT_NEAR(ladder.order(), GetParam().error_order + 1, 0.1) << ladder.print();
}

TEST_P(EveryPair, InterpolatesDensely) {
  const Ladder ladder = climb(0.2, GetParam().rungs, [&](double h) {
    ExplicitStepper coarse = at_start();
    walk(coarse, h, 1);
    double worst = 0;
    for (const double share : {0.2, 0.5, 0.7}) {
      ExplicitStepper there = at_start();
      walk(there, share * h, 50);
      worst = std::max(worst, (coarse.at(share * h) - there.y()).norm());
    }
    return worst;
  });
  EXPECT_NEAR(ladder.order(), GetParam().dense_power, 0.15) << ladder.print();
}

TEST_P(EveryPair, ReusesItsLastStageAsTheNextFirst) {
  int evaluations = 0;
  const auto counted = [&](double t, const VectorXd& y, VectorXd& rate) {
    ++evaluations;
    pendulum(t, y, rate);
  };
  ExplicitStepper stepper(GetParam().tableau(), counted, 0, pendulum_start);
  for (int i = 1; i <= 10; ++i) {
    stepper.attempt(0.1 * i);
    stepper.accept();
    VectorXd rate;
    pendulum(stepper.t(), stepper.y(), rate);
    EXPECT_EQ(stepper.rate(), rate);
  }
  EXPECT_EQ(evaluations, 1 + GetParam().evaluations * 10);
}

double amplitude_after(int steps, double h, const Tableau& tableau, const RateFunction& f, VectorXd y) {
  ExplicitStepper stepper(tableau, f, 0, std::move(y));
  walk(stepper, steps * h, steps);
  return stepper.y().norm();
}

TEST(RungeKutta, IsStableUpToAPhaseAndADecayAStep) {
  const auto swings = [](double h, const Tableau& tableau) {
    const auto f = [](double, const VectorXd& y, VectorXd& rate) { rate = VectorXd{{y[1], -y[0]}}; };
    return amplitude_after(20000, h, tableau, f, VectorXd{{1, 0}});
  };
  const auto decays = [](double h, const Tableau& tableau) {
    const auto f = [](double, const VectorXd& y, VectorXd& rate) { rate = -y; };
    return amplitude_after(4000, h, tableau, f, VectorXd{{1}});
  };
  EXPECT_LT(swings(2.82, kutta43()), 1);
  EXPECT_GT(swings(2.84, kutta43()), 1e3);
  EXPECT_LT(decays(2.78, kutta43()), 1);
  EXPECT_GT(decays(2.79, kutta43()), 1e3);
  EXPECT_LT(swings(0.99, dormand_prince54()), 1);
  EXPECT_GT(swings(1.1, dormand_prince54()), 1);
  EXPECT_LT(decays(3.30, dormand_prince54()), 1);
  EXPECT_GT(decays(3.31, dormand_prince54()), 1e3);
}

/// By its error alone, with nothing else to hold the step: after some 10000 steps, over the amplitude at first.
double growth_under(double relative, const Tableau& tableau) {
  const auto swing = [](double, const VectorXd& y, VectorXd& rate) { rate = VectorXd{{y[1], -y[0]}}; };
  ExplicitStepper stepper(tableau, swing, 0, VectorXd{{1, 0}});
  double step = 0.1;
  for (int i = 0; i < 10000; ++i) {
    stepper.attempt(stepper.t() + step);
    const double error = scaled_error(stepper.attempted(), stepper.error(), {relative, 0});
    step *= step_factor(error, tableau.error_order);
    if (error <= 1) stepper.accept();
  }
  return stepper.y().norm();
}

TEST(RungeKutta, LetsNoSwingRunAwayAtAToleranceThatASceneMayAskFor) {
  EXPECT_LT(growth_under(0.1, kutta43()), 1);
  EXPECT_LT(growth_under(1e-3, dormand_prince54()), 1);
  EXPECT_GT(growth_under(1e-2, dormand_prince54()), 10);
}

TEST(StepControl, ScalesTheErrorByTheLargerOfBothSolutions) {
  const VectorXd y{{2, -1}}, error{{-2, 0.5}};  // the embedded solution is (4, -1.5)
  const double a = 2 / (0.1 + 0.01 * 4), b = 0.5 / (0.1 + 0.01 * 1.5);
  EXPECT_NEAR(scaled_error(y, error, {0.01, 0.1}), std::sqrt((a * a + b * b) / 2), 1e-14);
}

TEST(StepControl, ChangesAStepByTheFourthRootOfItsErrorWithinAThirdAndThree) {
  EXPECT_NEAR(step_factor(16, 3), 0.45, 1e-15);
  EXPECT_NEAR(step_factor(1, 3), 0.9, 1e-15);
  EXPECT_EQ(step_factor(0, 3), 3);
  EXPECT_EQ(step_factor(1e9, 3), 1.0 / 3);
  EXPECT_EQ(step_factor(std::numeric_limits<double>::quiet_NaN(), 3), 1.0 / 3);
}

TEST(StepControl, TriesShorterStepsUntilOneMayBeKeptWhichDoesNotLengthenTheNext) {
  StepTries tries(1, 0.5, 10, 3);
  EXPECT_EQ(tries.to(), 1.5);
  EXPECT_FALSE(tries.keep(16));
  EXPECT_NEAR(tries.to(), 1 + 0.45 * 0.5, 1e-15);
  tries.halve();
  EXPECT_NEAR(tries.to(), 1 + 0.225 * 0.5, 1e-15);
  EXPECT_FALSE(tries.shorter_than(0.1));
  EXPECT_TRUE(tries.shorter_than(0.2));
  EXPECT_TRUE(tries.keep(1e-8));
  EXPECT_NEAR(tries.step(), 0.225 * 0.5, 1e-15);
}

TEST(StepControl, GoesAllTheWayRatherThanLeaveAHundredthOfAStep) {
  EXPECT_EQ(StepTries(0, 0.5, 0.5049, 3).to(), 0.5049);
  EXPECT_EQ(StepTries(0, 0.5, 0.5051, 3).to(), 0.5);
  EXPECT_FALSE(StepTries(0, 0.5, 1e-20, 3).shorter_than(1e-10));
  StepTries cut_short(0, 0.5, 0.01, 3);
  EXPECT_TRUE(cut_short.keep(1));
  EXPECT_EQ(cut_short.step(), 0.5);
}

/// y' = λ y from 1: |y| = 1/Rtol, |y'| = λ/Rtol, |y''| = λ²/Rtol in the scaled norm, so h⁵ λ²/Rtol = 0.01.
TEST(StepControl, BeginsWithHairersFirstStep) {
  const double lambda = -3, relative = 1e-6;
  const RateFunction f = [&](double, const VectorXd& y, VectorXd& rate) { rate = lambda * y; };
  const VectorXd y{{1}}, rate{{lambda}};
  EXPECT_NEAR(first_step(f, 0, y, rate, 4, {relative, 0}), std::pow(0.01 * relative / 9, 0.2), 1e-9);
}

TEST(StepControl, BeginsWithAStepThatIsNeitherRejectedNorTimid) {
  for (const double relative : {1e-3, 1e-6, 1e-9}) {
    ExplicitStepper stepper(kutta43(), pendulum, 0, pendulum_start);
    const Tolerance tolerance{relative, relative};
    stepper.attempt(first_step(pendulum, 0, stepper.y(), stepper.rate(), 4, tolerance));
    const double error = scaled_error(stepper.attempted(), stepper.error(), tolerance);
    EXPECT_LT(error, 1);
    EXPECT_GT(error, 1e-5);
  }
}

/// Two yarns that press on each other, with drag, for the solver as a whole.
struct Scuffle {
  OneThread one_thread;
  Fabric fabric = crossing_yarns(ContactLaw::barrier, 21);
  World world{fabric, {Stretch{}, Bend{}, Drag{}, Contact{}}, Schedule(0.0), at_rest(fabric)};
};

constexpr double duration = 2e-5;  // s, some hundred steps

TEST(RungeKutta, NeverPassesTheEndItIsGivenAndSaysWhenItIsThere) {
  Scuffle scuffle;
  const auto solver = make(RungeKutta{}, scuffle.world, at_rest(scuffle.fabric));
  Progress progress = Progress::stepped;
  while (progress == Progress::stepped) {
    progress = solver->advance(duration);
    EXPECT_LE(solver->state().t, duration);
  }
  EXPECT_EQ(progress, Progress::arrived);
  EXPECT_EQ(solver->state().t, duration);
  EXPECT_GT(solver->effort().accepted, 20);
  EXPECT_EQ(solver->advance(duration), Progress::arrived);
}

TEST(RungeKutta, KeepsItsStepWhenASampleCutsOneShort) {
  Scuffle scuffle;
  const auto solver = make(RungeKutta{}, scuffle.world, at_rest(scuffle.fabric));
  run_to(*solver, duration);
  const double step = solver->state().step;
  run_to(*solver, duration + 1e-3 * step);
  EXPECT_GE(solver->state().step, step);
}

TEST_P(EveryPair, GoesOnFromASavedStateAsIfItHadNeverStopped) {
  const RungeKutta spec{.method = GetParam().method};
  Scuffle whole, halves;
  const auto straight = make(spec, whole.world, at_rest(whole.fabric));
  const auto first = make(spec, halves.world, at_rest(halves.fabric));
  for (int i = 0; i < 17; ++i) ASSERT_EQ(first->advance(duration), Progress::stepped);

  Scuffle elsewhere;  // a fresh world, as after a restart of the program
  const auto second = make(spec, elsewhere.world, first->state());
  expect_same_bits(run_to(*second, duration), run_to(*straight, duration));
}

TEST_P(EveryPair, InterpolatesWithinItsLastStep) {
  Scuffle scuffle;
  const RungeKutta fine{.method = GetParam().method, .relative = 1e-8, .absolute = 1e-12};
  const auto solver = make(fine, scuffle.world, at_rest(scuffle.fabric));
  double from = 0;
  for (int i = 0; i < 30; ++i) {
    from = solver->state().t;
    ASSERT_EQ(solver->advance(duration), Progress::stepped);
  }
  EXPECT_EQ(solver->at(solver->state().t).q, solver->state().q);
  const double middle = (from + solver->state().t) / 2;
  const State between = solver->at(middle);
  EXPECT_EQ(between.t, middle);
  const auto again = make(fine, scuffle.world, at_rest(scuffle.fabric));
  const State there = run_to(*again, middle);
  EXPECT_LT((between.q - there.q).norm(), 1e-7 * (solver->state().q - at_rest(scuffle.fabric).q).norm());
  EXPECT_LT((between.v - there.v).norm(), 1e-6 * there.v.norm());
}

TEST(RungeKutta, FailsWithASentenceThatSaysWhere) {
  for (const double from : {0.0, duration / 2}) {
    Scuffle scuffle;
    scuffle.world.add(std::make_unique<Poison>(from, scuffle.fabric.yarns[1].first_point + 3));
    const auto solver = make(RungeKutta{}, scuffle.world, at_rest(scuffle.fabric));
    Progress progress = Progress::stepped;
    while (progress == Progress::stepped) progress = solver->advance(duration);
    EXPECT_EQ(progress, Progress::failed);
    EXPECT_TRUE(solver->effort().failure.ends_with(", in segment 8 of yarn 1")) << solver->effort().failure;
    EXPECT_TRUE(solver->state().q.allFinite());
    EXPECT_LE(solver->state().t, from);
  }
}

}  // namespace
}  // namespace wale
