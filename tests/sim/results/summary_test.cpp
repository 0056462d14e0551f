#include "sim/results/summary.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/sim/results/made_results.hpp"

namespace wale {
namespace {

using nlohmann::json;

TEST(Summary, TellsWhatTheRunWas) {
  const Results results = testing::made_results();
  const json told = json::parse(summary_json(results));
  EXPECT_EQ(told["version"], "0.1.0");
  EXPECT_EQ(told["scene"], "chart: ü\n");
  EXPECT_EQ(told["threads"], 2);
  EXPECT_EQ(told["unknowns"], 3 * 4 * (3 * 16 + 3));
  EXPECT_EQ(told["segments"], 4 * 3 * 16);
  EXPECT_EQ(told["contact_samples"], 1234567890123);
  EXPECT_EQ(told["complete"], true);
  EXPECT_EQ(told["warnings"][0], "the fabric is tight");
  EXPECT_EQ(told["solver"]["steps"], 10);
  EXPECT_EQ(told["solver"]["failure"], "the step became too small");
  EXPECT_EQ(told["sizes"]["thickness_m"], 5e-3);
}

TEST(Summary, AddsUpWallSecondsByPhase) {
  Results results = testing::made_results();
  results.phases.push_back({"pull", 4});
  const json seconds = json::parse(summary_json(results))["wall_seconds"];
  EXPECT_EQ(seconds["compile"], 0.5);
  EXPECT_EQ(seconds["prepare"], 3);
  EXPECT_EQ(seconds["solve"], 12);
  EXPECT_EQ(seconds["write"], 0.25);
  EXPECT_EQ(seconds["total"], 15.75);
  EXPECT_EQ(seconds["stages"]["tighten"], 2);
  EXPECT_EQ(seconds["stages"]["pull"], 12);
}

TEST(Summary, KnowsAPullByTheScene) {
  Results results;
  results.scene.stages.resize(2);
  results.scene.stages[0].name = "first";
  results.scene.stages[1].name = "stretched";
  results.scene.stages[1].pull = Pull{};
  results.phases = {{"first", 1}, {"stretched", 2}};
  const json seconds = json::parse(summary_json(results))["wall_seconds"];
  EXPECT_EQ(seconds["prepare"], 1);
  EXPECT_EQ(seconds["solve"], 2);
}

TEST(Summary, SaysWhetherEveryCrossingWasFound) {
  Results results = testing::made_results();
  EXPECT_EQ(json::parse(summary_json(results))["topology"],
            json::parse(R"({"crossings_expected": 18, "crossings_found": 17, "intact": false})"));
  results.topology.found = 18;
  EXPECT_EQ(json::parse(summary_json(results))["topology"]["intact"], true);
}

TEST(Summary, SaysHowNearlyAQuasiStaticStageBalances) {
  Results results = testing::made_results();
  EXPECT_TRUE(json::parse(summary_json(results))["balance"].empty());
  results.scene.stages.resize(2);
  results.scene.stages[1].name = "pull";
  results.scene.stages[1].pull = Pull{};
  append_row(results.samples, {{"stage", "", 1}, {"residual", "N", 1e-3}, {"force_per_wale", "N", 0.5}});
  const json balance = json::parse(summary_json(results))["balance"]["pull"];
  EXPECT_EQ(balance["residual_N"], 1e-3);
  EXPECT_EQ(balance["residual_over_load"], 2e-3);
  EXPECT_GT(balance["tolerance_N"], 1e-3);
}

TEST(Summary, HasNullForFeaturesOfNoCurve) {
  const json told = json::parse(summary_json({}));
  EXPECT_TRUE(told["curve"]["initial_stiffness_Pa"].is_null());
  EXPECT_TRUE(told["scene"].is_null());
  EXPECT_GT(json::parse(summary_json(testing::made_results()))["curve"]["final_stiffness_Pa"], 1e4);
}

}  // namespace
}  // namespace wale
