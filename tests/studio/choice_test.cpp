#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "sim/tile.hpp"
#include "studio/accuracy/adjust.hpp"
#include "studio/accuracy/along_yarn.hpp"
#include "studio/accuracy/common_rest.hpp"
#include "studio/accuracy/measured.hpp"
#include "studio/choice/settle.hpp"
#include "tests/studio/shell.hpp"

namespace wale {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();
constexpr double margin = 2.0 / 3;
constexpr Scales standard{
    .stitch_length = 7.23e-3, .diameter = 0.524e-3, .bending_force = 0.0537, .linear_density = 77e-6};

/// Ten scenes of one stitch length whose error is (12/n)² a hundredth, the last of them a hundred times that; the finer
/// of two finenesses has half the error at three times the cost.
Calibration quadratic() {
  Calibration of;
  of.friction_threshold = 0.15;
  of.segments = {12, 24, 48};
  of.fineness = {{0.03, 0.01, 0.04}, {0.015, 0.003, 0.02}};
  of.costs = {{0.5, 1, 2}, {1.5, 3, 6}};
  for (int i = 0; i < 10; ++i) {
    const double much = i == 9 ? 1 : 0.01;
    of.scenes.push_back({"", 12, 1e-5, {{much, much / 4, much / 16}, {much / 2, much / 8, much / 32}}});
  }
  return of;
}

TEST(ChooseResolution, TakesTheFewestSegmentsThatDoForNineOfTenScenes) {
  const Resolution of = choose_resolution(0.25e-2 / margin, standard, 0.04, quadratic());
  EXPECT_NEAR(of.segment_length, 0.5, 0.5 * 0.03) << "12 diameters of yarn in 24 segments";
  EXPECT_LE(of.segment_length, 0.5);
  EXPECT_EQ(of.segments_per_stitch, 2 * std::ceil(7.23 / 0.524 / of.segment_length / 2)) << "a longer stitch has more";
  EXPECT_EQ(of.fineness.sampling, 0.03);
  EXPECT_EQ(of.samples_times, 1);
  EXPECT_TRUE(of.reached());
}

TEST(ChooseResolution, RefinesTheRestWhereSegmentsDoNot) {
  const Resolution of = choose_resolution(0.04e-2 / margin, standard, 0.04, quadratic());
  EXPECT_EQ(of.fineness.sampling, 0.015) << "48 segments are off by 0.0625 % with the other";
  EXPECT_EQ(of.samples_times, 2);
  EXPECT_TRUE(of.reached());
}

TEST(ChooseResolution, SaysWhenNothingReachesWhatIsAsked) {
  const Resolution of = choose_resolution(0.01e-2, standard, 0.04, quadratic());
  EXPECT_FALSE(of.reached());
  EXPECT_NEAR(of.expected, 0.01 / 32, 1e-6);
}

TEST(ChooseResolution, DoesNotCountScenesWhoseOwnAnswerIsNotKnownSoWell) {
  Calibration of = quadratic();
  for (std::size_t i = 5; i < 10; ++i) of.scenes[i].reference = 0.1;
  EXPECT_EQ(choose_resolution(1e-2, standard, 0.04, of).scenes, 5);
}

TEST(ChooseResolution, OfTheShippedCalibrationCostsMoreTheMoreIsAsked) {
  double segments = 0;
  for (const double asked : {0.2, 0.1, 0.05, 0.02, 0.01}) {
    const Resolution of = choose_resolution(asked, standard, 0.04);
    EXPECT_TRUE(of.reached()) << asked;
    EXPECT_GE(of.segments_per_stitch, segments) << asked;
    segments = of.segments_per_stitch;
  }
}

/// A fabric of `courses` and one pull to 50 %, with every effect whose choice can be left open.
Scene open_scene(int courses, bool periodic) {
  Sources sources;
  Diagnostics say;
  sources.add("chart.yaml", "knit: 1\nwales: 4\nbands: [{stitch: jersey, courses: 4}]\n");
  return compile_scene(
             *sources.add("scene.yaml", "scene: 1\nfabric: {pattern: chart.yaml, courses: " + std::to_string(courses) +
                                            (periodic ? ", periodic: true" : "") +
                                            "}\neffects: auto\nstages:\n"
                                            "  - {name: relax, duration: 1 s}\n"
                                            "  - {name: pull, duration: 5 s, pull: {along: wale, to: 50 %}}\n"),
             sources, say)
      .value();
}

template <class Effect>
bool has(const Stage& stage) {
  return std::any_of(stage.effects.begin(), stage.effects.end(),
                     [](const EffectSpec& effect) { return std::holds_alternative<Effect>(effect); });
}

const Decision& find(const std::vector<Decision>& decisions, int stage, const std::string& effect) {
  return *std::find_if(decisions.begin(), decisions.end(),
                       [&](const Decision& each) { return each.stage == stage && each.effect == effect; });
}

TEST(DecideEffects, WeighsAWaleAgainstTheForceThatBendsIt) {
  Scene scene = open_scene(4, false);
  const auto decisions = decide_effects(scene, standard, 0.01);
  const double weight = 77e-6 * 7.23e-3 * 4 * 9.81;
  EXPECT_NEAR(*find(decisions, 1, "gravity").estimate, weight / (0.0537 * 0.5), 1e-12);
  EXPECT_FALSE(has<Gravity>(scene.stages[1])) << "0.08 % of the stress";
  EXPECT_TRUE(has<Gravity>(scene.stages[0])) << "0.4 % of what a tenth of strain takes";
}

TEST(DecideEffects, TakesInWhatIsHeavyOrMustBeExact) {
  Scene heavy = open_scene(4, false), exact = heavy;
  for_each_effect<Gravity>(heavy, [](Gravity& gravity) { gravity.acceleration *= 100; });
  decide_effects(heavy, standard, 0.01);
  EXPECT_TRUE(has<Gravity>(heavy.stages[1]));
  decide_effects(exact, standard, 0.001);
  EXPECT_TRUE(has<Gravity>(exact.stages[1]));
}

TEST(DecideEffects, FrictionRubsWhereYarnIsPulledAndWhereASwatchWouldSlideApart) {
  Scene cell = open_scene(4, true), swatch = open_scene(4, false);
  decide_effects(cell, standard, 0.01);
  EXPECT_FALSE(has<Friction>(cell.stages[0]));
  EXPECT_TRUE(has<Friction>(cell.stages[1]));
  decide_effects(swatch, standard, 0.01);
  EXPECT_TRUE(has<Friction>(swatch.stages[0]));
  Scene slippery = open_scene(4, true);
  for_each_effect<Friction>(slippery, [](Friction& friction) { friction.coefficient = 1e-3; });
  const auto decisions = decide_effects(slippery, standard, 0.01);
  EXPECT_FALSE(has<Friction>(slippery.stages[1])) << "0.16 %";
  EXPECT_TRUE(is_borderline(find(decisions, 1, "friction"), 0.01)) << "worth a try";
}

TEST(DecideEffects, FollowsInTimeWhatIsPulledFast) {
  Scene slow = open_scene(4, false), fast = slow;
  fast.stages[1].duration = 1e-3;
  const double at_5_s = *find(decide_effects(slow, standard, 0.01), 1, "inertia").estimate;
  const double at_1_ms = *find(decide_effects(fast, standard, 0.01), 1, "inertia").estimate;
  EXPECT_NEAR(at_1_ms / at_5_s, 25e6, 1e-3 * 25e6) << "as the square of the speed";
  EXPECT_TRUE(std::holds_alternative<QuasiStatic>(slow.stages[1].solver));
  EXPECT_TRUE(std::holds_alternative<Implicit>(fast.stages[1].solver));
  EXPECT_FALSE(has<Drag>(slow.stages[1])) << "nothing moves";
}

TEST(DecideEffects, LeavesAloneWhatAStageNames) {
  Scene scene = open_scene(4, false);
  for (Stage& stage : scene.stages) stage.effects_open = false;
  EXPECT_TRUE(decide_effects(scene, standard, 0.01).empty());
  EXPECT_TRUE(has<Gravity>(scene.stages[1]));
  EXPECT_TRUE(has<Drag>(scene.stages[1]));
}

/// Two resolutions of a fabric.
class Resampled : public testing::TestWithParam<bool> {
 protected:
  static Fabric fabric(int segments) {
    Sources sources;
    Diagnostics say;
    return compile_chart(*sources.add("chart.yaml", "knit: 1\nwales: 3\nbands: [{stitch: jersey, courses: 3}]\n"),
                         {.wales = {}, .courses = {}, .stitch_length = {}, .materials = {}, .periodic = GetParam()},
                         segments, say)
        .value()
        .fabric;
  }
  static Points state(const Fabric& of) { return of.cell ? points_and_periods(of) : of.points; }
};

TEST_P(Resampled, YarnsGoThroughTheSamePlaces) {
  const Fabric coarse = fabric(12), fine = fabric(24);
  const Points q = state(coarse), laid = resampled(coarse, q, fine);
  const double between = GetParam() ? 2e-6 : 5e-5;  // m; segments of a swatch's ends are of unequal length
  ASSERT_EQ(laid.cols(), state(fine).cols());
  for (std::size_t i = 0; i < fine.yarns.size(); ++i) {
    const AlongYarn on_coarse(coarse, coarse.yarns[i]), on_fine(fine, fine.yarns[i]);
    for (const double share : on_fine.ends())
      EXPECT_NEAR((on_fine.at(laid, share).y - on_coarse.at(q, share).y).norm(), 0, 1e-12);
    for (double share = 0; share < 1; share += 0.0037)
      EXPECT_NEAR((on_fine.at(laid, share).y - on_coarse.at(q, share).y).norm(), 0, between);
  }
}

TEST_P(Resampled, OnItsOwnSegmentsAYarnIsWhatItWas) {
  const Fabric of = fabric(12);
  const Points q = state(of);
  EXPECT_NEAR((resampled(of, q, of) - q).cwiseAbs().maxCoeff(), 0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(SwatchAndCell, Resampled, testing::Bool());

/// Of two scenes that no calibration has seen, against much finer settings from the same rest; bench/accuracy/hits.cpp
/// tries 26.
TEST(AskedAccuracy, IsReached) {
  for (const char* fabric : {"pattern: jersey.yaml, wales: 1, courses: 1, stitch_length: 6.7 mm",
                             "pattern: garter.yaml, wales: 1, courses: 2, stitch_length: 7.6 mm"}) {
    Sources sources;
    Diagnostics say;
    const SceneText text(*sources.add(WALE_SOURCE_DIR "/patterns/scene.yaml",
                                      std::string("scene: 1\naccuracy: 5 %\nfabric: {periodic: true, ") + fabric + R"(}
effects: auto
stages:
  - {name: tighten, duration: 1 s, tighten: 100 %, samples: 4}
  - {name: relax, duration: 1 s, samples: 1}
  - {name: pull, duration: 2 s, pull: {along: wale, to: 60 %}, samples: 8}
)"),
                         sources);
    const auto settled = settle(text, std::nullopt, say);
    ASSERT_TRUE(settled);
    Results chosen, finer;
    chosen.scene = settled->scene;
    ASSERT_EQ(run(chosen, {}), Outcome::finished);
    finer.scene = in_other_segments(text, *settled, 48).value();
    scale_sampling(finer.scene, 0.5);
    scale_tolerance(finer.scene, StageKind::strained, 0.3);
    scale_samples(finer.scene, 4);
    RunOptions from_rest;
    from_rest.begin = begin_at(rest_of(chosen).value(), finer.scene);
    ASSERT_EQ(run(finer, from_rest), Outcome::finished);
    const double error = difference(measured(chosen), measured(finer))[of_stress];
    EXPECT_LT(error, 0.05) << fabric;
    EXPECT_GT(error, 1e-4) << "they are not one run";
  }
}

class Choice : public testing::Test {
 protected:
  Choice() { scratch_.write("chart.yaml", "knit: 1\nwales: 1\nbands: [{stitch: jersey, courses: 1}]\n"); }
  std::string scene(const std::string& head) {
    return scratch_.write("scene.yaml", "scene: 1\n" + head + R"(
fabric: {pattern: chart.yaml, periodic: true}
stages:
  - {name: tighten, duration: 1 s, tighten: 100 %, samples: 2}
  - {name: relax, duration: 1 s, samples: 1}
  - {name: pull, duration: 2 s, pull: {along: wale, to: 40 %}, samples: 4}
)");
  }
  nlohmann::json read(const std::string& name) { return nlohmann::json::parse(test::read(scratch_.path(name))); }
  test::Scratch scratch_;
};

TEST_F(Choice, OfAnAccuracyIsSaidAndItsErrorEstimated) {
  const std::string path = scene("accuracy: 5 %\neffects: {stretch: , bend: , contact: }");
  const test::Answer answer = test::wale({"run", path, "-o", scratch_.path("out"), "--threads", "1"});
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.out.find("For an error of 5 % of the peak stress:"), std::string::npos) << answer.out;
  EXPECT_NE(answer.out.find("Estimated error: "), std::string::npos) << answer.out;
  const auto summary = read("out/summary.json"), choices = read("out/choices.json");
  EXPECT_EQ(summary["accuracy"]["asked"], 0.05);
  EXPECT_GT(summary["accuracy"]["estimated_error"].get<double>(), 0);
  EXPECT_EQ(choices["accuracy"]["segments_written"], 12);
  EXPECT_LT(choices["second_solution"]["segments_per_stitch"], choices["accuracy"]["segments_per_stitch"]);
}

/// Pulled both ways at once a jersey is harder than most.
TEST_F(Choice, IsRunAnewFinerWhereItIsNotReached) {
  const std::string path = scratch_.write("scene.yaml", R"(scene: 1
accuracy: 5 %
fabric: {pattern: chart.yaml, periodic: true}
effects: {stretch: , bend: , contact: }
stages:
  - {name: tighten, duration: 1 s, tighten: 100 %, samples: 4}
  - {name: relax, duration: 1 s, samples: 1}
  - {name: pull, duration: 5 s, deform: {wale: 40 %, course: 40 %, shear: held}, samples: 20, effects: {friction: }}
)");
  const test::Answer answer = test::wale({"run", path, "-o", scratch_.path("out"), "--threads", "1"});
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.out.find("(5 % asked for): run anew with "), std::string::npos) << answer.out;
  const auto choices = read("out/choices.json"), summary = read("out/summary.json");
  const int refinements = choices["accuracy"]["refinements"];
  ASSERT_GE(refinements, 1);
  EXPECT_EQ(choices["before_refinement"].size(), static_cast<std::size_t>(refinements));
  EXPECT_GT(choices["before_refinement"][0]["estimated_error"].get<double>(), 0.05);
  EXPECT_LT(choices["second_solution"]["estimated_error"].get<double>(), 0.05);
  EXPECT_EQ(summary["accuracy"]["estimated_error"], choices["second_solution"]["estimated_error"]);
  EXPECT_EQ(summary["curve"]["samples"], 20 * choices["accuracy"]["samples_times"].get<int>() + 1)
      << "the results are those of the last run";
  EXPECT_EQ(test::wale({"run", "--resume", scratch_.path("out"), "--threads", "1"}).exit_code, 0);
  EXPECT_EQ(read("out/choices.json")["accuracy"]["refinements"], refinements) << "the file knows its settings";
}

TEST_F(Choice, OnTheCommandLineGoesBeforeTheScenes) {
  const std::string path = scene("accuracy: 20 %\neffects: auto");
  ASSERT_EQ(test::wale({"run", path, "-o", scratch_.path("out"), "--accuracy", "2%"}).exit_code, 0);
  EXPECT_EQ(read("out/summary.json")["accuracy"]["asked"], 0.02);
  const test::Answer bad = test::wale({"run", path, "-o", scratch_.path("other"), "--accuracy", "2 mm"});
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_NE(bad.err.find("--accuracy:1:1"), std::string::npos) << bad.err;
}

TEST_F(Choice, IsMadeAgainWhenARunIsResumed) {
  const std::string path = scene("effects: auto");
  ASSERT_EQ(test::wale({"run", path, "-o", scratch_.path("out"), "--accuracy", "3 %"}).exit_code, 0);
  const test::Answer answer = test::wale({"run", "--resume", scratch_.path("out")});
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(read("out/summary.json")["accuracy"]["asked"], 0.03);
}

TEST_F(Choice, IsExplainedWithoutARun) {
  const test::Answer answer = test::wale({"explain", scene("accuracy: 2 %\neffects: auto")});
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.out.find("For an error of 2 %"), std::string::npos) << answer.out;
  EXPECT_NE(answer.out.find("friction  in        changes the stress by an estimated 60 %"), std::string::npos)
      << answer.out;
  const auto json = nlohmann::json::parse(test::wale({"explain", scene("effects: auto"), "--json"}).out);
  EXPECT_TRUE(json["accuracy"].is_null());
  EXPECT_EQ(json["effects"][0]["effect"], "stretch");
}

TEST_F(Choice, TriesWhatWasLeftOutByLittle) {
  const std::string path = scene("effects: {auto: , friction: {coefficient: 0.001}}");
  const test::Answer answer = test::wale({"run", path, "-o", scratch_.path("out")});
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.out.find("friction was left out of \"pull\" (0.16 % estimated); with it the answer changes by"),
            std::string::npos)
      << answer.out;
}

}  // namespace
}  // namespace wale
