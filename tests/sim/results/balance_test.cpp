#include "sim/results/balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/results/recorder.hpp"

namespace wale {
namespace {

/// Tightens, pulls along the courses and shears, each by another solver's leave.
Results three_stages() {
  Results results;
  results.scene.fabric.materials = {Material{}};
  results.scene.stages.resize(3);
  results.scene.stages[0].name = "tighten";
  results.scene.stages[0].solver = QuasiStatic{.tolerance = 1};
  results.scene.stages[1].name = "pull";
  results.scene.stages[1].pull = Pull{Along::course, {0.1}};
  results.scene.stages[2].name = "shear";
  results.scene.stages[2].deform = Deform{};
  results.scene.gauge.wales = 2;
  results.scene.gauge.courses = 4;
  results.scene.gauge.thickness = 1e-3;
  results.relaxed.width = 6e-3;
  results.relaxed.length = 8e-3;
  append_row(results.samples, {{"stage", "1", 0}});
  append_row(results.samples, {{"stage", "1", 0}, {"residual", "N", 0.05}});
  append_row(results.samples, {{"stage", "1", 1}, {"force_per_wale", "N", 0}, {"residual", "N", 2e-4}});
  append_row(results.samples, {{"stage", "1", 1}, {"force_per_wale", "N", -0.02}, {"residual", "N", 1e-4}});
  append_row(results.samples,
             {{"stage", "1", 2}, {"stress.shear", "Pa", -1e4}, {"stress.course", "Pa", 1}, {"residual", "N", 3e-4}});
  return results;
}

TEST(Balance, IsTheLargestResidualBesideTheToleranceAndTheLargestLoad) {
  const std::vector<Balance> all = balances(three_stages());
  ASSERT_EQ(all.size(), 3U);
  const Material yarn;
  EXPECT_EQ(all[0].stage, "tighten");
  EXPECT_EQ(all[0].residual, 0.05);
  EXPECT_DOUBLE_EQ(all[0].tolerance, yarn.bending_rigidity / (yarn.diameter * yarn.diameter));
  EXPECT_TRUE(std::isnan(all[0].share())) << "nothing is pulled";
  EXPECT_EQ(all[1].residual, 2e-4);
  EXPECT_EQ(all[1].load, 0.02);
  EXPECT_EQ(all[1].along, Along::course);
  EXPECT_DOUBLE_EQ(all[1].share(), 0.01);
}

TEST(Balance, OfADeformationIsBesideTheStressTimesItsSection) {
  const Balance shear = balances(three_stages()).at(2);
  EXPECT_DOUBLE_EQ(shear.load, 1e4 * 6e-3 * 1e-3 / 2);
  EXPECT_EQ(shear.along, Along::wale);
}

TEST(Balance, LeavesOutWhatFollowsAMotionOrHasNotBegun) {
  Results results = three_stages();
  results.scene.stages[0].solver = RungeKutta{};
  results.scene.stages.emplace_back();
  EXPECT_EQ(balances(results).size(), 2U);
  EXPECT_TRUE(balances({}).empty());
}

}  // namespace
}  // namespace wale
