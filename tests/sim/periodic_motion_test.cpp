#include <gtest/gtest.h>

#include "sim/solver.hpp"
#include "tests/support/moving_cells.hpp"
#include "tests/support/one_thread.hpp"
#include "tests/support/poison.hpp"
#include "tests/support/solver_runs.hpp"

namespace wale {
namespace {

constexpr double each = 1e-4;  // s

MovingCell beaten(int repeats, const std::vector<EffectSpec>& more = {}, PeriodGuide::Part across = held()) {
  const LaidCell cell = several(resting_stitch(), repeats, repeats);
  std::vector<EffectSpec> effects{Stretch{}, Bend{}, Contact{}, Drag{},
                                  ContactDamping{.tangential = 10, .normal = 100}};
  effects.insert(effects.end(), more.begin(), more.end());
  return {cell, effects, lengthened(cell, {0.05, 0.02}, each, std::move(across))};
}

/// In a step and at a turn of what leads it.
TEST(PeriodicMotion, GoesOnFromASavedStateAsIfItHadNeverStopped) {
  const OneThread one;
  const auto check = [](const auto& spec, const std::vector<EffectSpec>& more, const PeriodGuide::Part& across) {
    const auto anew = [&] { return beaten(1, more, across); };
    MovingCell whole = anew(), first_half = anew(), second_half = anew(), turned = anew();
    const auto straight = make(spec, whole.world(), whole.start());
    const auto first = make(spec, first_half.world(), first_half.start());
    for (int i = 0; i < 5; ++i) ASSERT_EQ(first->advance(each), Progress::stepped);
    const auto second = make(spec, second_half.world(), first->state());
    expect_same_bits(run_to(*second, each), run_to(*straight, each));
    const auto third = make(spec, turned.world(), second->state());
    expect_same_bits(run_to(*third, 2 * each), run_to(*straight, 2 * each));
  };
  for (const PeriodGuide::Part& across : {held(), PeriodGuide::Part{}}) {
    check(RungeKutta{}, {}, across);
    check(Implicit{}, {Friction{}}, across);
  }
}

TEST(PeriodicMotion, GivesTheSameBitsForTwoThreads) {
  const OneThread guard;
  std::vector<State> ends;
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    MovingCell cell = beaten(2, {Friction{}});
    const auto solver = make(Implicit{}, cell.world(), cell.start());
    for (int i = 0; i < 5; ++i) ASSERT_EQ(solver->advance(each), Progress::stepped) << solver->effort().failure;
    ends.push_back(solver->state());
  }
  expect_same_bits(ends[0], ends[1]);
}

/// What follows another point does so to the last bit, however long it moves.
TEST(PeriodicMotion, KeepsItsPeriodsWhereTheyAreLed) {
  const OneThread one;
  MovingCell cell = beaten(1);
  const auto solver = make(Implicit{}, cell.world(), cell.start());
  for (const double until : {each / 3, each, 2 * each}) {
    const State now = run_to(*solver, until);
    State led = now;
    cell.world().guide().lead(*cell.world().fabric().cell, led);
    EXPECT_LT((now.q - led.q).norm(), 1e-15 * now.q.norm());
    const Ties& ties = cell.world().ties();
    EXPECT_EQ(ties.spread(ties.pick(now.q)), now.q);
    EXPECT_EQ(ties.spread(ties.pick(now.v)), now.v);
  }
}

/// A fabric that only flows with its periods does not move beside that, and has no kinetic energy.
TEST(PeriodicMotion, LetsTheFabricGoAlongWithItsPeriods) {
  const LaidCell cell = several(resting_stitch(), 1, 2);
  for (PeriodGuide guide :
       {lengthened(cell, {0.1}, each), PeriodGuide{led(Schedule::ramp(cell.q(0, cell.q.cols() - 2), 1e-2, each)),
                                                   held(), led(Schedule::ramp(0, 1e-3, each))}}) {
    MovingCell moving(cell, {Stretch{}}, guide);
    State now = moving.struck(0.3, 5);
    const double before = moving.kinetic(now);
    ASSERT_TRUE(guide.pace(now, each));
    EXPECT_NEAR(moving.kinetic(now), before, 1e-12 * before);
    EXPECT_FALSE(guide.pace(now, each)) << "goes already";
    State later = now;
    later.t = each;
    guide.lead(*moving.world().fabric().cell, later);
    EXPECT_LT((later.q.rightCols<2>() - now.q.rightCols<2>() - each * now.v.rightCols<2>()).norm(), 1e-15);
  }
}

TEST(PeriodicMotion, FailsWithASentenceThatSaysWhere) {
  const OneThread one;
  const auto check = [](const auto& spec) {
    MovingCell cell = beaten(1);
    cell.world().add(std::make_unique<Poison>(each / 2, 5));
    const auto solver = make(spec, cell.world(), cell.start());
    Progress progress = Progress::stepped;
    while (progress == Progress::stepped) progress = solver->advance(each);
    EXPECT_EQ(progress, Progress::failed);
    EXPECT_NE(solver->effort().failure.find("segment 4 of yarn 0"), std::string::npos) << solver->effort().failure;
    EXPECT_TRUE(solver->state().q.allFinite());
  };
  check(RungeKutta{});
  check(Implicit{});
}

}  // namespace
}  // namespace wale
