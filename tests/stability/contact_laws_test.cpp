#include <gtest/gtest.h>

#include "tests/stability/passing_through.hpp"
#include "tests/stability/trial.hpp"
#include "tests/support/one_thread.hpp"

namespace wale::stability {
namespace {

Verdict by_explicit_motion(const char* name, double rung, ContactLaw law) {
  Results results;
  return attempt(hard_scene(hard_case(name), rung, SolverKind::runge_kutta, law), results);
}

/// Ding et al. 2023, Eq. 18, ten times as stiff as the barrier: finite where axes meet.
TEST(QuadraticPenalty, LetsYarnsThroughUnderLoadsThatTheOtherLawsBear) {
  const OneThread one;
  const std::pair<const char*, double> cases[] = {
      {"hooked loops pulled", 2}, {"yarn driven across yarn", 5}, {"yarn jerked across yarn", 100}};
  for (const auto& [name, rung] : cases) {
    SCOPED_TRACE(name);
    const Verdict through = by_explicit_motion(name, rung, ContactLaw::quadratic);
    EXPECT_EQ(through.end, Verdict::End::broke);
    EXPECT_NE(through.what.find("linking number"), std::string::npos) << through.what;
    for (const ContactLaw law : {ContactLaw::barrier, ContactLaw::core_shell})
      EXPECT_TRUE(by_explicit_motion(name, rung, law).held()) << name_of(law);
  }
}

/// Beads are samples, so that even the barrier bears only so much; the solver says so before yarns are through.
TEST(Barrier, IsGivenUpBeforeYarnsSlipBetweenItsBeads) {
  const OneThread one;
  const Verdict verdict = by_explicit_motion("hooked loops pulled", 4, ContactLaw::barrier);
  EXPECT_EQ(verdict.end, Verdict::End::gave_up) << verdict.what;
  EXPECT_NE(verdict.what.find("pass through each other"), std::string::npos) << verdict.what;
}

TEST(DampedStart, FindsEquilibriaThatNoStepIsShortEnoughFor) {
  const OneThread one;
  Results results;
  const auto hard = hard_scene(hard_case("hooked loops pulled"), 4, SolverKind::quasi_static, ContactLaw::barrier);
  EXPECT_EQ(attempt(hard, results).end, Verdict::End::gave_up);
  EXPECT_GT(results.effort.retries.halved, 0);
  EXPECT_GT(results.effort.retries.damped, 1) << "all but the last were of use";
}

/// Left to itself the core and shell law finds no equilibrium there: what touches a core stops at once.
TEST(AnotherLawsStart, FindsEquilibriaThatTheLawItselfDoesNot) {
  const OneThread one;
  Results results;
  const auto hard =
      hard_scene(hard_case("overhand knot tightened"), 5, SolverKind::quasi_static, ContactLaw::core_shell);
  EXPECT_EQ(attempt(hard, results).end, Verdict::End::held);
  EXPECT_GT(results.effort.retries.detoured, 0);
}

}  // namespace
}  // namespace wale::stability
