#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <map>

#include "tests/stability/renumbered.hpp"
#include "tests/stability/trial.hpp"
#include "tests/support/one_thread.hpp"
#include "tests/support/solver_runs.hpp"

namespace wale::stability {
namespace {

constexpr SolverKind kinds[] = {SolverKind::runge_kutta, SolverKind::implicit, SolverKind::quasi_static};

void expect_same_states(const Results& a, const Results& b) {
  ASSERT_EQ(a.snapshots.size(), b.snapshots.size());
  for (std::size_t i = 0; i < a.snapshots.size(); ++i) expect_same_bits(a.snapshots[i].state, b.snapshots[i].state);
}

/// A scene of few, long steps, so that samples do not cut all of them short.
HardScene sampled_once(const char* name, double rung, SolverKind kind) {
  HardScene hard = hard_scene(hard_case(name), rung, kind, ContactLaw::barrier);
  for (Stage& stage : hard.scene.stages) {
    stage.samples = 1;
    if (auto* still = std::get_if<QuasiStatic>(&stage.solver)) still->first_step = 0.05;
  }
  return hard;
}

struct SomeCase {
  const char* name;
  double rung;
};
constexpr SomeCase some_cases[] = {{"overlap at the start", 50}, {"yarn jerked across yarn", 100}};

TEST(HardRuns, HaveTheSameBitsForAnyNumberOfThreads) {
  for (const SolverKind kind : kinds) {
    SCOPED_TRACE(name_of(kind));
    const HardScene hard = hard_scene(hard_case("swatch with a yarn cut"), 50, kind, ContactLaw::barrier);
    std::map<int, Results> by_threads;
    const int before = omp_get_max_threads();
    for (const int threads : {1, 2}) {
      omp_set_num_threads(threads);
      EXPECT_TRUE(attempt(hard, by_threads[threads], {.steps = 60}).end != Verdict::End::broke);
    }
    omp_set_num_threads(before);
    expect_same_states(by_threads[1], by_threads[2]);
  }
}

/// Within one step the middle of a swatch falls by several stitches, and draws its yarn from other loops.
TEST(HardRuns, FollowLoopsThroughAStepInWhichTheirYarnGoesToOthers) {
  const OneThread one;
  const HardScene hard =
      hard_scene(hard_case("swatch under its weight"), 1e5, SolverKind::quasi_static, ContactLaw::barrier);
  Results results;
  EXPECT_TRUE(attempt(hard, results).held());
  EXPECT_EQ(results.topology.found, results.topology.expected);
}

TEST(HardRuns, GoOnWithTheSameBitsFromWhereverTheyWereStopped) {
  const OneThread one;
  for (const auto& [name, rung] : some_cases)
    for (const SolverKind kind : kinds) {
      SCOPED_TRACE(std::string(name) + " by " + name_of(kind));
      const HardScene hard = sampled_once(name, rung, kind);
      Results whole;
      ASSERT_TRUE(attempt(hard, whole).held());
      for (const double share : {0.0, 0.1, 0.5, 0.9}) {
        Results stopped;
        const long steps = 1 + static_cast<long>(share * static_cast<double>(whole.effort.accepted - 2));
        ASSERT_EQ(attempt(hard, stopped, {.steps = steps}).end, Verdict::End::too_long);
        ASSERT_TRUE(attempt(hard, stopped).held());
        expect_same_states(stopped, whole);
      }
    }
}

TEST(HardRuns, GoOnWithTheSameBitsThoughStoppedAtEveryStep) {
  const OneThread one;
  for (const SolverKind kind : {SolverKind::implicit, SolverKind::quasi_static}) {
    SCOPED_TRACE(name_of(kind));
    const HardScene hard = sampled_once("friction", 0.3, kind);
    Results whole, stopped;
    ASSERT_TRUE(attempt(hard, whole, {.steps = 60}).end != Verdict::End::broke);
    while (stopped.effort.accepted < whole.effort.accepted) attempt(hard, stopped, {.steps = 1});
    expect_same_bits(stopped.snapshots.back().state, whole.snapshots.back().state);
  }
}

/// Rounding differs, and motion that is not damped carries that on: for so short a time not far.
TEST(HardRuns, DoNotDependOnTheOrderOfYarns) {
  const OneThread one;
  for (const auto& [name, rung] : some_cases)
    for (const SolverKind kind : kinds) {
      SCOPED_TRACE(std::string(name) + " by " + name_of(kind));
      const HardScene hard = hard_scene(hard_case(name), rung, kind, ContactLaw::barrier);
      const HardScene other_order = renumbered(hard);
      Results results, other;
      ASSERT_TRUE(attempt(hard, results).held());
      ASSERT_TRUE(attempt(other_order, other).held());
      const Points q = last_yarn_first(hard.scene.fabric, results.snapshots.back().state.q);
      EXPECT_LT((q - other.snapshots.back().state.q).cwiseAbs().maxCoeff(),
                1e-2 * hard.scene.fabric.materials[0].diameter);
    }
}

/// More than contact bears: every solver says so, keeps the last good state, and says so again when taken up.
TEST(HardRuns, ThatCannotBeFinishedSaySoAndCanBeTakenUpAgain) {
  const OneThread one;
  for (const SolverKind kind : kinds) {
    SCOPED_TRACE(name_of(kind));
    const HardScene hard = hard_scene(hard_case("yarn driven across yarn"), 8, kind, ContactLaw::barrier);
    Results results;
    const Verdict first = attempt(hard, results);
    EXPECT_EQ(first.end, Verdict::End::gave_up) << first.what;
    const State& last = results.snapshots.back().state;
    EXPECT_GT(last.t, 0);
    const double reached = last.t;
    const Verdict again = attempt(hard, results);
    EXPECT_EQ(again.end, Verdict::End::gave_up) << again.what;
    EXPECT_GE(results.snapshots.back().state.t, reached);
    EXPECT_EQ(results.snapshots.back().stage, 0);
  }
}

/// What stands still goes on to stand still: thousands of steps move nothing.
TEST(HardRuns, DoNotDriftAtRest) {
  const OneThread one;
  HardScene hard = hard_scene(hard_case("hooked loops pulled"), 0.5, SolverKind::quasi_static, ContactLaw::barrier);
  Stage rest = hard.scene.stages.front();
  rest.samples = 4;
  for (EffectSpec& effect : rest.effects)
    if (auto* tether = std::get_if<Tether>(&effect)) {
      tether->move = Vec3::Zero();
      // Grips hold what lies in them when a stage begins, so that each time they give way anew: here by very little.
      tether->stiffness *= 1e4;
    }
  hard.scene.stages.insert(hard.scene.stages.end(), 2, rest);
  for (Stage& stage : hard.scene.stages) stage.solver = QuasiStatic{.tolerance = 1e-8};
  hard.scene.stages.back().solver = RungeKutta{};
  Results results;
  const Verdict verdict = attempt(hard, results, {.steps = 10000});
  EXPECT_NE(verdict.end, Verdict::End::broke) << verdict.what;
  const Points& q = results.snapshots.back().state.q;
  const auto start = std::find_if(results.snapshots.begin(), results.snapshots.end(),
                                  [](const Snapshot& snapshot) { return snapshot.stage == 2; });
  EXPECT_LT((q - start->state.q).cwiseAbs().maxCoeff(), 1e-3 * hard.scene.fabric.materials[0].diameter);
}

}  // namespace
}  // namespace wale::stability
