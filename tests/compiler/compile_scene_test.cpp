#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "compiler/compile.hpp"

namespace wale {
namespace {

std::optional<Scene> first_stitch(Sources& sources, Diagnostics& say) {
  const Source* source = sources.read(std::string(WALE_SOURCE_DIR) + "/examples/01_first_stitch/scene.yaml");
  return source ? compile_scene(*source, sources, say) : std::nullopt;
}

TEST(CompileScene, MakesTheFirstExampleReadyToRun) {
  Sources sources;
  Diagnostics say;
  const auto scene = first_stitch(sources, say);
  ASSERT_TRUE(scene);
  EXPECT_FALSE(say.failed());
  const int stitches = 12 * 13 * 12;
  EXPECT_GT(scene->fabric.segment_count(), stitches);
  EXPECT_LT(scene->fabric.segment_count(), stitches * 4 / 3);
  EXPECT_EQ(scene->fabric.points.cols(), scene->fabric.segment_count() + 3);
  EXPECT_EQ(scene->crossings.size(), 2U * 11 * 12);
  EXPECT_EQ(scene->gauge.wales, 12);
  EXPECT_EQ(scene->gauge.courses, 13);
  EXPECT_DOUBLE_EQ(scene->gauge.thickness, 1.048e-3);
  EXPECT_FALSE(scene->stages.empty());
}

TEST(CompileScene, KnowsWhereEachStitchIsWritten) {
  Sources sources;
  Diagnostics say;
  const Source* source = sources.add("a/scene.yaml", R"(scene: 1
fabric: {pattern: chart.yaml, periodic: true, segments_per_stitch: 8}
effects: {stretch: }
stages: [{name: relax, duration: 1 s}]
)");
  sources.add("a/chart.yaml", R"(knit: 1
bands:
  - stitch: |
      kp
      kk
)");
  const auto scene = compile_scene(*source, sources, say);
  ASSERT_TRUE(scene) << print(say.all().front());
  EXPECT_EQ(scene->fabric.source, "a/chart.yaml");
  std::set<std::pair<int, int>> places;
  for (const Segment& segment : scene->fabric.segments) places.emplace(segment.line, segment.column);
  const std::set<std::pair<int, int>> written{{4, 7}, {4, 8}, {5, 7}, {5, 8}};
  EXPECT_EQ(places, written);
}

TEST(CompileScene, GripsBothEndsEitherWay) {
  Sources sources;
  Diagnostics say;
  const auto scene = first_stitch(sources, say);
  ASSERT_TRUE(scene);
  for (const auto& ends : {scene->gauge.wale_ends, scene->gauge.course_ends})
    for (const auto& end : ends) {
      EXPECT_FALSE(end.empty());
      for (const int segment : end) EXPECT_TRUE(segment >= 0 && segment < scene->fabric.segment_count());
    }
}

TEST(CompileScene, TiesBothYarnEndsToStitchesNearby) {
  Sources sources;
  Diagnostics say;
  const auto scene = first_stitch(sources, say);
  ASSERT_TRUE(scene);
  for (const Stage& stage : scene->stages)
    for (const EffectSpec& effect : stage.effects)
      if (const Knots* knots = std::get_if<Knots>(&effect)) {
        ASSERT_EQ(knots->knots.size(), 2U) << stage.name;
        EXPECT_EQ(knots->knots[0].segment_a, 0);
        EXPECT_EQ(knots->knots[1].segment_a, scene->fabric.segment_count() - 1);
        for (const Knot& knot : knots->knots) EXPECT_GE(scene->fabric.segment(knot.segment_b).stitch, 0);
        return;
      }
  FAIL() << "the example has no knots";
}

TEST(CompileScene, TakesTwoDiametersForTheThicknessThatNobodyGave) {
  Sources sources;
  Diagnostics say;
  const std::string text = R"(scene: 1
name: no gauge
fabric: {pattern: patterns/jersey.yaml, wales: 4, courses: 3, stitch_length: 7.23 mm}
effects: {stretch: , bend: }
stages:
  - {name: relax, duration: 1 s, samples: 1}
solver: {quasi_static: {}}
)";
  const auto scene = compile_scene(*sources.add(std::string(WALE_SOURCE_DIR) + "/scene.yaml", text), sources, say);
  for (const Diagnostic& one : say.all()) EXPECT_NE(one.severity, Severity::error) << print(one);
  ASSERT_TRUE(scene);
  EXPECT_DOUBLE_EQ(scene->gauge.thickness, 2 * Material{}.diameter);
}

/// A scene of `program` with `keys` besides the pattern in its `fabric`.
std::optional<Scene> compile_program(Sources& sources, const std::string& program, const std::string& keys,
                                     Diagnostics& say) {
  sources.add("program.k", program);
  const std::string text = "scene: 1\nfabric: {pattern: program.k, " + keys +
                           "}\neffects: {stretch: , bend: }\nstages: [{name: relax, duration: 1 s}]\n";
  return compile_scene(*sources.add("scene.yaml", text), sources, say);
}

TEST(CompileScene, KnitsEverySettingOfAMachineWithItsOwnStitchLength) {
  Sources sources;
  Diagnostics say;
  const auto scene = compile_program(sources,
                                     ";!knitout-2\n;;Carriers: 1\nin 1\nx-stitch-number 4\nknit + f0 1\nknit + f1 1\n"
                                     "knit + f2 1\nx-stitch-number 6\nknit - f2 1\nknit - f1 1\nknit - f0 1\nout 1\n",
                                     "stitch_length: {otherwise: 8 mm, 6: 9 mm}", say);
  ASSERT_TRUE(scene);
  std::map<int, double> knitted, longest;
  for (const Segment& segment : scene->fabric.segments) {
    knitted[segment.stitch] += segment.knitted;
    longest[segment.stitch] = std::max(longest[segment.stitch], segment.knitted);
  }
  for (int loop = 0; loop < 6; ++loop) EXPECT_NEAR(knitted[loop], loop < 3 ? 8e-3 : 9e-3, longest[loop]) << loop;
}

TEST(CompileScene, GivesSomeYarnsOfAChartTheirOwnMaterials) {
  Sources sources;
  Diagnostics say;
  sources.add("stripes.yaml",
              "knit: 1\nwales: 4\nyarns: {a: , b: , c: paper-as-printed}\nbands:\n"
              "  - {stitch: jersey, courses: 6, stitch_length: 2 cm, yarn: [a, b, c]}\n");
  const auto scene =
      compile_scene(*sources.add("scene.yaml",
                                 "scene: 1\nfabric: {pattern: stripes.yaml, yarns: {b: {contact_diameter: 0.3 mm}}}\n"
                                 "effects: {stretch: , bend: }\nstages: [{name: relax, duration: 1 s}]\n"),
                    sources, say);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->fabric.materials.at(0), Material{});
  EXPECT_EQ(scene->fabric.materials.at(1), (Material{.name = "b", .diameter = 0.3e-3}));
  EXPECT_EQ(scene->fabric.materials.at(2).name, "paper-as-printed");
}

TEST(CompileScene, KnowsWhichMaterialsTheNamesOfYarnsMean) {
  Sources sources;
  Diagnostics say;
  sources.add("stripes.yaml",
              "knit: 1\nwales: 4\nyarns: {a: , b: , c: }\nbands:\n"
              "  - {stitch: jersey, courses: 6, stitch_length: 2 cm, yarn: [a, b, c]}\n");
  const auto scene = compile_scene(*sources.add("scene.yaml",
                                                "scene: 1\nfabric: {pattern: stripes.yaml}\n"
                                                "effects: {stretch: , gravity: {on: [c, a]}}\n"
                                                "stages: [{name: heat, duration: 1 s, shrink: {yarn: b, by: 20 %}}]\n"),
                                   sources, say);
  ASSERT_TRUE(scene) << print(say.all().front());
  EXPECT_EQ(std::get<Gravity>(scene->stages[0].effects[1]).on.materials, (std::vector{2, 0}));
  EXPECT_EQ(scene->stages[0].shrink[0].materials, std::vector{1});
}

TEST(CompileScene, KnowsWhichSegmentsARegionHolds) {
  Sources sources;
  Diagnostics say;
  sources.add("stripes.yaml",
              "knit: 1\nwales: 4\nyarns: {a: , b: }\nbands: [{stitch: jersey, courses: 6, yarn: [a, b]}]\n");
  sources.add("narrow.k",
              ";!knitout-2\n;;Carriers: 1\nin 1\ntuck - f2 1\ntuck - f0 1\ntuck + f1 1\nknit - f2 1\n"
              "knit - f1 1\nknit - f0 1\nknit + f0 1\nknit + f1 1\nknit + f2 1\nout 1\n");
  const auto segments = [&](const std::string& pattern, const std::string& on) {
    const auto scene = compile_scene(
        *sources.add("scene.yaml", "scene: 1\nfabric: {pattern: " + pattern + "}\neffects: {gravity: {on: " + on +
                                       "}}\nstages: [{name: fall, duration: 1 s}]\n"),
        sources, say);
    EXPECT_FALSE(say.failed());
    return std::get<Gravity>(scene->stages[0].effects[0]).on.segments.size();
  };
  EXPECT_EQ(segments("stripes.yaml", "{courses: 2-3, wales: 1-4}"), 2U * 4 * 12);
  EXPECT_EQ(segments("stripes.yaml", "{courses: 6}"), 4U * 12);
  EXPECT_EQ(segments("stripes.yaml", "{wales: 4}"), 6U * 12);
  EXPECT_EQ(segments("narrow.k", "{courses: 2, needles: 0-1}"), 2U * 12);
}

TEST(CompileScene, MakesOneRepeatOfAPeriodicFabric) {
  Sources sources;
  Diagnostics say;
  const std::string text =
      "scene: 1\nfabric: {pattern: patterns/jersey.yaml, wales: 2, courses: 3, periodic: true}\n"
      "effects: {stretch: , bend: , contact: }\n"
      "stages: [{name: pull, duration: 8 s, pull: {along: wale, to: 60 %}}]\n";
  const auto scene = compile_scene(*sources.add(std::string(WALE_SOURCE_DIR) + "/scene.yaml", text), sources, say);
  for (const Diagnostic& one : say.all()) ADD_FAILURE() << print(one);
  ASSERT_TRUE(scene);
  EXPECT_TRUE(scene->fabric.cell);
  EXPECT_EQ(scene->fabric.yarns.size(), 3U);
  EXPECT_EQ(scene->fabric.segment_count(), 2 * 3 * 12);
  EXPECT_EQ(scene->crossings.size(), 12U);
  EXPECT_EQ(scene->gauge.wales, 2);
  EXPECT_EQ(scene->gauge.courses, 3);
  for (const auto& ends : {scene->gauge.wale_ends, scene->gauge.course_ends})
    for (const auto& end : ends) EXPECT_TRUE(end.empty());
}

TEST(CompileScene, SaysWhatIsWrongAndGivesNothing) {
  Sources sources;
  Diagnostics say;
  EXPECT_FALSE(compile_scene(*sources.add("scene.yaml", "scene: 1\nfabric: {pattern: nowhere.yaml}\n"), sources, say));
  EXPECT_TRUE(say.failed());
}

}  // namespace
}  // namespace wale
