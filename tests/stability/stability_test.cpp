#include <gtest/gtest.h>

#include <algorithm>

#include "tests/stability/trial.hpp"
#include "tests/support/one_thread.hpp"

namespace wale::stability {
namespace {

struct Climb {
  const HardCase* of = nullptr;
  SolverKind solver{};
};

std::vector<Climb> all_climbs() {
  std::vector<Climb> climbs;
  for (const HardCase& of : hard_cases())
    for (const SolverKind solver : of.solvers) climbs.push_back({&of, solver});
  return climbs;
}

std::string name_of(const testing::TestParamInfo<Climb>& info) {
  std::string name = info.param.of->name + " by " + name_of(info.param.solver);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

class HardCases : public testing::TestWithParam<Climb> {
  const OneThread one_;
};

TEST_P(HardCases, HoldOnTheirFirstRungs) {
  const auto& [of, solver] = GetParam();
  for (const double rung : of->quick) {
    Results results;
    const Verdict verdict = attempt(hard_scene(*of, rung, solver, ContactLaw::barrier), results);
    EXPECT_TRUE(verdict.held()) << rung << " " << of->unit << ": " << verdict.what;
  }
}

INSTANTIATE_TEST_SUITE_P(All, HardCases, testing::ValuesIn(all_climbs()), name_of);

}  // namespace
}  // namespace wale::stability
