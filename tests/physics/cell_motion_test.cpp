/// The motion of fabrics without end, whose periods are held, led or free.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/solver.hpp"
#include "tests/support/convergence.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/moving_cells.hpp"
#include "tests/support/one_thread.hpp"
#include "tests/support/solver_runs.hpp"

namespace wale {
namespace {

constexpr double pi = std::numbers::pi;
constexpr RungeKutta exact{.relative = 1e-6, .absolute = 1e-12};
constexpr Implicit fine{.relative = 1e-3, .absolute = 1e-10, .absolute_speed = 1e-5};

class CellMotion : public ::testing::Test {
  OneThread one_;
};

/// An endless straight yarn, by a repeat of it.
LaidCell endless_yarn(double length, double stretched, int segments) {
  LaidCell cell;
  cell.fabric.materials = {Material{}};
  add_yarn(cell.fabric, straight_points(Vec3::Zero(), {stretched, 0, 0}, segments), length / segments);
  cell.fabric.cell = PeriodicCell{{stretched, 0, 0}, {0, 1e-2, 0}};
  cell.q = points_and_periods(cell.fabric);
  return cell;
}

/// Over the amplitude, how far a standing wave of one repeat is from where it passes through nothing after a quarter of
/// `period`.
double off_after_a_quarter(const LaidCell& cell, const Vec3& along, double period) {
  MovingCell moving(cell, {Stretch{.nodes = 3}});
  const double amplitude = 3e-7;
  const int segments = cell.fabric.segment_count();
  State start = moving.start();
  for (int k = 0; k < segments + 3; ++k) start.q.col(k) += amplitude * std::cos(2 * pi * k / segments) * along;
  const State end = run_to(*make(RungeKutta{.relative = 1e-10, .absolute = 1e-13}, moving.world(), start), period / 4);
  return (along.transpose() * (end.q - moving.start().q)).cwiseAbs().maxCoeff() / amplitude;
}

/// Along an unstretched yarn waves run at √(EA/rho); across one that is stretched by λ at √(EA (λ - 1)/(rho λ)),
/// counted in unstretched yarn.
TEST_F(CellMotion, CarriesWavesOfOneRepeatAtTheirSpeeds) {
  const double length = 6e-3, lambda = 1.2;
  const Material yarn;
  const double along = std::sqrt(yarn.axial_stiffness / yarn.linear_density),
               across = along * std::sqrt((lambda - 1) / lambda);
  const auto ladder = [&](double stretched, const Vec3& direction, double speed) {
    return climb(1.0 / 6, 3, [&](double share) {
      const LaidCell cell = endless_yarn(length, stretched, static_cast<int>(std::lround(1 / share)));
      return off_after_a_quarter(cell, direction, length / speed);
    });
  };
  const Ladder longitudinal = ladder(length, Vec3::UnitX(), along),
               transverse = ladder(lambda * length, Vec3::UnitZ(), across);
  for (const Ladder& waves : {longitudinal, transverse}) {
    EXPECT_LT(waves.error.back(), 1e-5) << waves.print();
    EXPECT_GT(waves.order(), 3) << waves.print();
  }
}

TEST_F(CellMotion, KeepsMomentumAndEnergyIfNothingRubs) {
  MovingCell moving(several(resting_stitch(), 1, 2), {Stretch{}, Bend{}, Contact{}});
  const State start = moving.struck(0.05, 3);
  const auto solver = make(exact, moving.world(), start);
  const double energy = moving.energy(start);
  const Vec3 momentum = moving.momentum(start);
  const double carried = moving.world().mass().times(start.v).colwise().norm().sum();
  const State end = run_to(*solver, 1e-4);
  EXPECT_GT((end.v - start.v).norm(), 0.3 * start.v.norm());
  EXPECT_LT((moving.momentum(end) - momentum).norm(), 1e-11 * carried);
  EXPECT_NEAR(moving.energy(end), energy, 1e-6 * moving.kinetic(start));
  EXPECT_EQ(end.q.rightCols<2>(), start.q.rightCols<2>());
}

TEST_F(CellMotion, KeepsMomentumAndGainsNoEnergyImplicitly) {
  MovingCell moving(several(resting_stitch(), 1, 2),
                    {Stretch{}, Bend{}, Contact{}, ContactDamping{.tangential = 10, .normal = 100}, Friction{}});
  const State start = moving.struck(0.05, 3);
  const auto solver = make(Implicit{}, moving.world(), start);
  const Vec3 momentum = moving.momentum(start);
  const double carried = moving.world().mass().times(start.v).colwise().norm().sum(), kinetic = moving.kinetic(start);
  double before = moving.energy(start);
  const double first = before;
  while (solver->advance(2e-3) == Progress::stepped) {
    const State& now = solver->state();
    EXPECT_LT((moving.momentum(now) - momentum).norm(), 1e-8 * carried);
    EXPECT_LT(moving.energy(now) - before, 1e-3 * kinetic);
    before = moving.energy(now);
  }
  ASSERT_EQ(solver->state().t, 2e-3) << solver->effort().failure;
  EXPECT_LT(before, first - 0.5 * kinetic);
}

/// All periods are free. Beside their flow no momentum comes from inside, and none is there at the start.
TEST_F(CellMotion, KeepsMomentumAndEnergyIfItsPeriodsAreFree) {
  MovingCell moving(several(resting_stitch(), 1, 2), {Stretch{}, Bend{}, Contact{}}, {});
  State start = moving.struck(0.05, 3);
  const double mass = moving.world().mass().times(Points::Ones(3, start.q.cols())).row(0).sum();
  start.v.leftCols(start.q.cols() - 2).colwise() -= Vec3(moving.momentum(start) / mass);
  start.v.topRows<2>() += 10 * start.q.topRows<2>();  // 1/s
  const auto solver = make(exact, moving.world(), start);
  const double energy = moving.energy(start);
  const double carried = moving.world().mass().times(start.v).colwise().norm().sum();
  const State end = run_to(*solver, 1e-4);
  EXPECT_LT(moving.momentum(end).norm(), 1e-11 * carried);
  EXPECT_NEAR(moving.energy(end), energy, 1e-6 * moving.kinetic(start));
  const Points gone = end.q.rightCols<2>() - start.q.rightCols<2>();
  EXPECT_GT(std::abs(gone(0, 0)), 1e-7);
  EXPECT_GT(std::abs(gone(1, 1)), 1e-7);
  EXPECT_EQ(gone.col(0).tail<2>(), Eigen::Vector2d::Zero()) << "the repeat turns";
}

/// A yarn of stiffness EA/l on the inertia of its period.
TEST_F(CellMotion, RingsAsAFreePeriodIsInert) {
  const double length = 6e-3, amplitude = 1e-4;
  const LaidCell cell = endless_yarn(length, (1 + amplitude) * length, 6);
  const Material yarn;
  MovingCell moving(cell, {Stretch{.nodes = 3}}, {{}, held(), held()});
  const double inertia =
      yarn.linear_density * length / 12 * std::pow(10 * yarn.diameter / ((1 + amplitude) * length), 2);
  const double quarter = pi / 2 * std::sqrt(inertia * length / yarn.axial_stiffness);
  const auto stretch_after = [&](const auto& spec) {
    const State end = run_to(*make(spec, moving.world(), moving.start()), quarter);
    return (end.q(0, end.q.cols() - 2) / length - 1) / amplitude;
  };
  EXPECT_LT(std::abs(stretch_after(RungeKutta{.relative = 1e-8, .absolute = 1e-14})), 1e-5);
  EXPECT_LT(std::abs(stretch_after(Implicit{.relative = 1e-5, .absolute = 1e-14, .absolute_speed = 1e-7})), 1e-2);
}

/// The work of what leads the periods, by Simpson's rule on the dense output of every step, there and back.
TEST_F(CellMotion, StoresTheWorkOfWhatLeadsIt) {
  const LaidCell cell = resting_stitch();
  const double each = 5e-5;
  MovingCell moving(cell, {Stretch{}, Bend{}, Contact{}}, lengthened(cell, {0.05, 0.02}, each));
  const auto solver = make(exact, moving.world(), moving.start());
  const auto power = [&](const State& at) { return moving.load(at)(1, 1) * at.v(1, at.v.cols() - 1); };
  double work = 0, most = 0;
  for (const double until : {each, 2 * each})
    for (Progress progress = Progress::stepped; progress == Progress::stepped;) {
      const double t = solver->state().t;
      progress = solver->advance(until);
      const double now = solver->state().t, h = now - t;
      work += h / 6 * (power(solver->at(t)) + 4 * power(solver->at(t + h / 2)) + power(solver->at(now)));
      most = std::max(most, work);
    }
  ASSERT_EQ(solver->state().t, 2 * each) << solver->effort().failure;
  EXPECT_GT(moving.kinetic(solver->state()), 0.001 * most) << "too slow to tell";
  EXPECT_NEAR(moving.energy(solver->state()) - moving.energy(moving.start()), work, 1e-5 * most);
}

std::vector<EffectSpec> elastic_and(const std::vector<EffectSpec>& more) {
  std::vector<EffectSpec> effects{Stretch{}, Bend{}, Contact{}};
  effects.insert(effects.end(), more.begin(), more.end());
  return effects;
}

const ContactDamping damping{.tangential = 10, .normal = 100};

/// A fabric that is led along the wales by `strain` and half back, each in as many seconds.
struct Beat {
  double strain = 0.1, each = 1e-4;
  double struck = 0;   ///< m/s: how fast its points move at the start
  bool slack = false;  ///< whether its course period is free
  PeriodGuide::Part across() const { return slack ? PeriodGuide::Part{} : held(); }
};

/// What leads the periods bears, on the width of one repeat, at eight times.
std::vector<double> curve(LaidCell cell, int repeats_across, const auto& spec, const Beat& beat,
                          const std::vector<EffectSpec>& more) {
  PeriodGuide guide = lengthened(cell, {beat.strain, beat.strain / 2}, beat.each, beat.across());
  MovingCell moving(std::move(cell), elastic_and(more), std::move(guide));
  const auto solver = make(spec, moving.world(), moving.struck(beat.struck, 3));
  std::vector<double> loads;
  for (int i = 1; i <= 8; ++i) loads.push_back(moving.load(run_to(*solver, i * beat.each / 4))(1, 1) / repeats_across);
  return loads;
}

void expect_near(const std::vector<double>& loads, const std::vector<double>& expected, double share) {
  double most = 0;
  for (const double load : expected) most = std::max(most, std::abs(load));
  for (std::size_t i = 0; i < loads.size(); ++i) EXPECT_NEAR(loads[i], expected[i], share * most) << i;
}

Beat slackened(Beat beat) {
  beat.slack = true;
  return beat;
}

constexpr Beat hard{.strain = 0.02, .each = 2e-5};
const std::vector<EffectSpec> rubbing{Drag{.coefficient = 0.05}, damping};

/// With all that depends on velocity, and faster than it can follow.
TEST_F(CellMotion, IsTheSameHoweverManyRepeatsMakeOneAndWhereverTheyBegin) {
  const LaidCell one = several(resting_stitch(), 1, 1);
  const auto check = [&](const auto& spec, const Beat& beat, double share) {
    const std::vector<double> expected = curve(one, 1, spec, beat, rubbing);
    expect_near(curve(several(one, 2, 1), 2, spec, beat, rubbing), expected, share);
    expect_near(curve(several(one, 1, 2), 1, spec, beat, rubbing), expected, share);
    expect_near(curve(begun_later(one, 5), 1, spec, beat, rubbing), expected, share);
  };
  check(exact, hard, 1e-5);
  check(exact, slackened(hard), 1e-5);
  check(fine, {}, 0.02);
  check(fine, slackened({}), 0.02);
}

/// Two courses that move otherwise than each other, one of them said to be a period further down.
TEST_F(CellMotion, IsTheSameWhereverItsCoursesAreCut) {
  const LaidCell two = several(resting_stitch(), 1, 2);
  LaidCell apart = two;
  const Yarn& upper = apart.fabric.yarns[1];
  apart.q.middleCols(upper.first_point, upper.points()).colwise() -= apart.q.col(apart.q.cols() - 1).eval();
  Beat struck = hard;
  struck.struck = 0.5;
  for (const Beat& beat : {struck, slackened(struck)})
    expect_near(curve(apart, 1, exact, beat, rubbing), curve(two, 1, exact, beat, rubbing), 1e-5);
}

/// Where the yarns are; what they bear rings, and implicit steps do not follow that.
TEST_F(CellMotion, IsTheSameByExplicitAndImplicitSteps) {
  const LaidCell cell = resting_stitch();
  for (const Beat& beat : {Beat{}, slackened({})}) {
    const auto moved = [&](const auto& spec) {
      MovingCell moving(cell, elastic_and({damping}), lengthened(cell, {0.1, 0.05}, beat.each, beat.across()));
      const auto solver = make(spec, moving.world(), moving.start());
      run_to(*solver, beat.each);
      return Points(run_to(*solver, 2 * beat.each).q - cell.q);
    };
    const Points explicitly = moved(exact);
    EXPECT_LT((moved(fine) - explicitly).norm(), 0.02 * explicitly.norm());
  }
}

/// A yarn that waves while it is stretched, or springs back.
class OrderOfSteps : public CellMotion, public ::testing::WithParamInterface<bool> {};
INSTANTIATE_TEST_SUITE_P(, OrderOfSteps, ::testing::Bool(),
                         [](const auto& of) { return of.param ? "WherePeriodsAreFree" : "WherePeriodsAreLed"; });

TEST_P(OrderOfSteps, IsTwoIfImplicit) {
  const LaidCell cell = endless_yarn(6e-3, 7.2e-3, 8);
  const double until = 6e-6;
  const PeriodGuide::Part along = GetParam() ? PeriodGuide::Part{} : led(Schedule::ramp(7.2e-3, 7.3e-3, until));
  MovingCell moving(cell, {Stretch{}, Bend{}}, {along, held(), held()});
  State start = moving.start();
  for (int k = 0; k < 11; ++k) start.q.col(k) += 1e-4 * Vec3(std::sin(pi * k / 2), 0, std::cos(pi * k / 4));
  const State at_end = run_to(*make(RungeKutta{.relative = 1e-10, .absolute = 1e-14}, moving.world(), start), until);
  const Ladder ladder = climb(until / 32, 4, [&](double h) {
    const int steps = static_cast<int>(std::lround(until / h));
    State now = start;
    for (int i = 1; i <= steps; ++i) {
      now.step = 0;
      now = run_to(*make(Implicit{.relative = 1e-9, .absolute = 1e3, .absolute_speed = 1e3, .first_step = 1e3},
                         moving.world(), now),
                   until * i / steps);
    }
    return (now.q - at_end.q).norm();
  });
  EXPECT_NEAR(ladder.order(), 2, 0.15) << ladder.print();
}

TEST_F(CellMotion, GoesFromEquilibriumToEquilibriumIfLedSlowly) {
  const LaidCell cell = resting_stitch();
  for (const Beat& slow : {Beat{.each = 0.1}, slackened({.each = 0.1})}) {
    const QuasiStatic at_rest{.tolerance = 1e-4, .first_step = slow.each / 8};
    std::vector<double> moved = curve(cell, 1, Implicit{}, slow, {Drag{}}), still = curve(cell, 1, at_rest, slow, {});
    // On the way back a motion that is free across falls to a rest of less energy, which equilibria pass by.
    for (auto* loads : {&moved, &still}) loads->resize(slow.slack ? 4 : 8);
    expect_near(moved, still, slow.slack ? 1e-4 : 0.01);
  }
}

}  // namespace
}  // namespace wale
