#include <gtest/gtest.h>

#include <limits>

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

/// After `steps` even steps to t = 2.
ExplicitStepper swing(int steps) {
  ExplicitStepper stepper(classic43(), pendulum, 0, pendulum_start);
  for (int i = 1; i <= steps; ++i) {
    stepper.attempt(2.0 * i / steps);
    stepper.accept();
  }
  return stepper;
}

const VectorXd& exact_swing() {
  static const VectorXd y = swing(20000).y();
  return y;
}

TEST(RungeKutta, HasATableauWhoseRowsAddUp) {
  const Tableau& table = classic43();
  for (std::size_t i = 0; i < table.c.size(); ++i) {
    double sum = 0;
    for (const double a : table.a[i]) sum += a;
    EXPECT_NEAR(sum, table.c[i], 1e-15);
  }
  // b̂ = b - error, as printed in model.md.
  const double expected[] = {1.0 / 12, 1.0 / 2, 1.0 / 4, 0, 1.0 / 6};
  for (std::size_t i = 0; i < 5; ++i) {
    const double b = i < 4 ? table.a[4][i] : 0;
    EXPECT_NEAR(b - table.error[i], expected[i], 1e-16);
  }
}

TEST(RungeKutta, IsOfOrderFour) {
  const Ladder ladder =
      climb(0.1, 5, [](double h) { return (swing(static_cast<int>(std::lround(2 / h))).y() - exact_swing()).norm(); });
  EXPECT_NEAR(ladder.order(), 4, 0.1) << ladder.print();
}

TEST(RungeKutta, EstimatesTheErrorOfASolutionOfOrderThree) {
  const Ladder ladder = climb(0.1, 6, [](double h) {
    ExplicitStepper stepper(classic43(), pendulum, 0, pendulum_start);
    stepper.attempt(h);
    return stepper.error().norm();
  });
  EXPECT_NEAR(ladder.order(), 3 + 1, 0.1) << ladder.print();
}

TEST(RungeKutta, InterpolatesDenselyToOrderFour) {
  const Ladder ladder = climb(0.2, 6, [](double h) {
    ExplicitStepper coarse(classic43(), pendulum, 0, pendulum_start), fine = coarse;
    coarse.attempt(h);
    coarse.accept();
    double worst = 0;
    for (const double share : {0.2, 0.5, 0.7}) {
      ExplicitStepper there = fine;
      for (int i = 1; i <= 50; ++i) {
        there.attempt(share * h * i / 50);
        there.accept();
      }
      worst = std::max(worst, (coarse.at(share * h) - there.y()).norm());
    }
    return worst;
  });
  // The interpolation error of a step is of the fourth power of its length: order four for the output.
  EXPECT_NEAR(ladder.order(), 4, 0.15) << ladder.print();
}

TEST(RungeKutta, ReusesItsLastStageAsTheNextFirst) {
  int evaluations = 0;
  ExplicitStepper stepper(
      classic43(),
      [&](double t, const VectorXd& y, VectorXd& rate) {
        ++evaluations;
        pendulum(t, y, rate);
      },
      0, pendulum_start);
  for (int i = 1; i <= 10; ++i) {
    stepper.attempt(0.1 * i);
    stepper.accept();
    VectorXd rate;
    pendulum(stepper.t(), stepper.y(), rate);
    EXPECT_EQ(stepper.rate(), rate);
  }
  EXPECT_EQ(evaluations, 1 + 4 * 10);
}

double amplitude_after(double h, const RateFunction& f, VectorXd y, int steps) {
  ExplicitStepper stepper(classic43(), f, 0, std::move(y));
  for (int i = 1; i <= steps; ++i) {
    stepper.attempt(stepper.t() + h);
    stepper.accept();
  }
  return stepper.y().norm();
}

TEST(RungeKutta, IsStableUpToAPhaseOf2828AndADecayOf2785AStep) {
  const auto oscillate = [](double, const VectorXd& y, VectorXd& rate) { rate = VectorXd{{y[1], -y[0]}}; };
  const auto decay = [](double, const VectorXd& y, VectorXd& rate) { rate = -y; };
  EXPECT_LT(amplitude_after(2.82, oscillate, VectorXd{{1, 0}}, 2000), 1);
  EXPECT_GT(amplitude_after(2.84, oscillate, VectorXd{{1, 0}}, 2000), 1e3);
  EXPECT_LT(amplitude_after(2.78, decay, VectorXd{{1}}, 2000), 1);
  EXPECT_GT(amplitude_after(2.79, decay, VectorXd{{1}}, 4000), 1e3);
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

/// y' = λ y from 1: |y| = 1/Rtol, |y'| = λ/Rtol, |y''| = λ²/Rtol in the scaled norm, so h⁵ λ²/Rtol = 0.01.
TEST(StepControl, BeginsWithHairersFirstStep) {
  const double lambda = -3, relative = 1e-6;
  const RateFunction f = [&](double, const VectorXd& y, VectorXd& rate) { rate = lambda * y; };
  const VectorXd y{{1}}, rate{{lambda}};
  EXPECT_NEAR(first_step(f, 0, y, rate, 4, {relative, 0}), std::pow(0.01 * relative / 9, 0.2), 1e-9);
}

TEST(StepControl, BeginsWithAStepThatIsNeitherRejectedNorTimid) {
  for (const double relative : {1e-3, 1e-6, 1e-9}) {
    ExplicitStepper stepper(classic43(), pendulum, 0, pendulum_start);
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

TEST(RungeKutta, GoesOnFromASavedStateAsIfItHadNeverStopped) {
  Scuffle whole, halves;
  const auto straight = make(RungeKutta{}, whole.world, at_rest(whole.fabric));
  const auto first = make(RungeKutta{}, halves.world, at_rest(halves.fabric));
  for (int i = 0; i < 17; ++i) ASSERT_EQ(first->advance(duration), Progress::stepped);

  Scuffle elsewhere;  // a fresh world, as after a restart of the program
  const auto second = make(RungeKutta{}, elsewhere.world, first->state());
  expect_same_bits(run_to(*second, duration), run_to(*straight, duration));
}

TEST(RungeKutta, InterpolatesWithinItsLastStep) {
  Scuffle scuffle;
  const RungeKutta fine{.relative = 1e-8, .absolute = 1e-12};
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

TEST(RungeKutta, FailsWithASentenceWhenTheForcesAreNotFinite) {
  for (const double from : {0.0, duration / 2}) {
    Scuffle scuffle;
    scuffle.world.add(std::make_unique<Poison>(from));
    const auto solver = make(RungeKutta{}, scuffle.world, at_rest(scuffle.fabric));
    Progress progress = Progress::stepped;
    while (progress == Progress::stepped) progress = solver->advance(duration);
    EXPECT_EQ(progress, Progress::failed);
    EXPECT_FALSE(solver->effort().failure.empty());
    EXPECT_TRUE(solver->state().q.allFinite());
    EXPECT_LE(solver->state().t, from);
  }
}

}  // namespace
}  // namespace wale
