#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <stdexcept>

#include "compiler/compile.hpp"
#include "sim/clasps.hpp"
#include "sim/results/topology.hpp"
#include "sim/tile.hpp"
#include "tests/support/structures.hpp"

namespace wale {
namespace {

constexpr int segments_per_stitch = 12;

Chart repeat_of(const std::vector<std::string>& picture) {
  Chart chart = make_chart(picture);
  chart.periodic = true;
  return chart;
}

/// The basic structures by their smallest repeats, and mixtures.
std::vector<NamedChart> repeats() {
  std::vector<NamedChart> charts{{"jersey", repeat_of({"k"})},
                                 {"reverse jersey", repeat_of({"p"})},
                                 {"garter", repeat_of({"p", "k"})},
                                 {"rib 1x1", repeat_of({"kp"})},
                                 {"rib 2x2", repeat_of({"kkpp"})},
                                 {"seed", repeat_of({"pk", "kp"})},
                                 {"moss", repeat_of({"pk", "pk", "kp", "kp"})},
                                 {"odd basket", repeat_of({"kkp", "kpp", "ppk"})}};
  for (unsigned seed = 0; seed < 6; ++seed) {
    Chart chart = make_random_chart(3 + static_cast<int>(seed % 4) * 3, 2 + static_cast<int>(seed * 3 % 8), Form::flat,
                                    seed + 20);
    chart.periodic = true;
    charts.push_back({"mixture " + std::to_string(seed), std::move(chart)});
  }
  return charts;
}

CompiledChart compiled(const Chart& chart, int segments = segments_per_stitch) {
  Diagnostics say;
  auto made = compile_chart(chart, segments, say);
  for (const Diagnostic& one : say.all()) ADD_FAILURE() << print(one);
  if (!made) throw std::runtime_error("the chart was refused");
  return std::move(*made);
}

Fabric tiled(const Fabric& periodic, int across, int up) {
  return tile(periodic, points_and_periods(periodic), across, up);
}

/// The tile that crossings refer to.
Fabric tiled(const CompiledChart& made) { return tiled(made.fabric, repeats_for_crossings, repeats_for_crossings); }

TEST(Periodic, EveryCourseIsAYarnThatGoesOnAfterThePeriod) {
  for (const auto& [name, chart] : repeats()) {
    SCOPED_TRACE(name);
    const Fabric fabric = compiled(chart).fabric;
    ASSERT_TRUE(fabric.cell);
    EXPECT_GT(fabric.cell->course.x(), 0);
    EXPECT_EQ(fabric.cell->course, Vec3(fabric.cell->course.x(), 0, 0));
    EXPECT_GT(fabric.cell->wale.y(), 0);
    EXPECT_EQ(fabric.cell->wale, Vec3(0, fabric.cell->wale.y(), 0));
    ASSERT_EQ(fabric.yarns.size(), static_cast<std::size_t>(chart.course_count()));
    for (const Yarn& yarn : fabric.yarns) {
      EXPECT_EQ(yarn.segments, segments_per_stitch * chart.wales());
      for (int k = 0; k < 3; ++k) {
        const Vec3 first = fabric.points.col(yarn.first_point + k);
        EXPECT_EQ(Vec3(fabric.points.col(yarn.first_point + yarn.segments + k)), first + fabric.cell->course);
      }
    }
  }
}

TEST(Periodic, IsTheSameFabricHoweverManyRepeatsMakeOne) {
  const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> pairs{
      {{"k"}, {"kkk", "kkk"}}, {{"p", "k"}, {"pp", "kk", "pp", "kk"}}, {{"kp"}, {"kpkp", "kpkp", "kpkp"}}};
  for (const auto& [small, large] : pairs) {
    const Fabric one = compiled(repeat_of(small)).fabric, several = compiled(repeat_of(large)).fabric;
    const int across = static_cast<int>(large[0].size() / small[0].size());
    const int up = static_cast<int>(large.size() / small.size());
    const Fabric made = tiled(one, across, up);
    EXPECT_LT((made.points - several.points).cwiseAbs().maxCoeff(), 1e-9) << small[0];
    EXPECT_NEAR(across * one.cell->course.x(), several.cell->course.x(), 1e-9);
    EXPECT_NEAR(up * one.cell->wale.y(), several.cell->wale.y(), 1e-9);
  }
}

TEST(Periodic, HasEveryCrossingBesideItsLikeAndNoneInItsMirrorImage) {
  for (const auto& [name, chart] : repeats()) {
    SCOPED_TRACE(name);
    const CompiledChart made = compiled(chart);
    const Fabric fabric = tiled(made);
    EXPECT_EQ(made.crossings.size(), static_cast<std::size_t>(2 * chart.wales() * chart.course_count()));
    for (const Crossing& crossing : made.crossings)
      EXPECT_TRUE(crosses_twice(fabric, crossing, fabric.points, Vec3::UnitZ()));
    EXPECT_TRUE(check_crossings(fabric, made.crossings, fabric.points).intact());
    Points mirrored = fabric.points;
    mirrored.row(2) *= -1;
    EXPECT_EQ(check_crossings(fabric, made.crossings, mirrored).found, 0);
  }
}

TEST(Periodic, NamesTheCrossingsOfItsMiddleRepeat) {
  const CompiledChart made = compiled(repeat_of({"kp", "pk", "kk"}));
  const Fabric fabric = tiled(made);
  std::map<int, int> sides;
  for (const Crossing& crossing : made.crossings) {
    const Loop& below = made.graph.loops[static_cast<std::size_t>(fabric.segment(crossing.loop_first).stitch)];
    const int middle = (crossing.side_first + crossing.side_last) / 2;
    const Loop& above = made.graph.loops[static_cast<std::size_t>(fabric.segment(middle).stitch)];
    EXPECT_EQ((above.cell.course - below.cell.course + 3) % 3, 1);
    const int yarn = fabric.segment(middle).yarn;
    EXPECT_TRUE(yarn >= 3 && yarn < 6) << yarn;
    EXPECT_EQ(fabric.segment(crossing.loop_first).yarn, yarn - 1);
    ++sides[fabric.segment(crossing.loop_first).stitch];
  }
  EXPECT_EQ(sides.size(), 6U);
  for (const auto& [stitch, count] : sides) EXPECT_EQ(count, 2) << stitch;
}

TEST(Periodic, LeadsEverySegmentBackToItsCell) {
  const CompiledChart made = compiled(repeat_of({"kkp", "pkk"}));
  for (int i = 0; i < made.fabric.segment_count(); ++i) {
    const Segment& segment = made.fabric.segment(i);
    ASSERT_GE(segment.stitch, 0);
    const int wale =
        (i - made.fabric.yarns[static_cast<std::size_t>(segment.yarn)].first_segment) / segments_per_stitch;
    const Cell& cell = made.chart.courses[static_cast<std::size_t>(segment.yarn)][static_cast<std::size_t>(wale)];
    const Span& span = made.graph.loops[static_cast<std::size_t>(segment.stitch)].span;
    EXPECT_EQ(span.begin, cell.span.begin) << i;
  }
}

TEST(Periodic, KnitsEveryCourseToItsLengthAndInItsYarn) {
  Chart chart = repeat_of({"kp", "kp", "kp"});
  chart.yarns.push_back({"b", Material{.name = "other", .diameter = 0.4e-3}, "#ffffff"});
  for (Cell& cell : chart.courses[1]) cell.yarn = 1, cell.stitch_length = 8e-3;
  const Fabric fabric = compiled(chart).fabric;
  ASSERT_EQ(fabric.materials.size(), 2U);
  std::vector<double> knitted(3, 0);
  for (const Segment& segment : fabric.segments) {
    knitted[static_cast<std::size_t>(segment.yarn)] += segment.knitted;
    EXPECT_EQ(fabric.materials[static_cast<std::size_t>(segment.material)].name,
              segment.yarn == 1 ? "other" : Material{}.name);
  }
  EXPECT_NEAR(knitted[0], 2 * 7.23e-3, 1e-5);
  EXPECT_NEAR(knitted[1], 2 * 8e-3, 1e-5);
}

TEST(Periodic, IsContinuedToAllSides) {
  Diagnostics say;
  const auto larger = passes::continue_chart(repeat_of({"kpp", "kkp"}), say);
  ASSERT_TRUE(larger);
  const Chart& chart = larger->chart;
  const int margin = larger->repeat.margin;
  ASSERT_EQ(chart.wales(), 3 + 2 * margin);
  ASSERT_EQ(chart.course_count(), 2 + 2 * margin);
  for (int course = 0; course < chart.course_count(); ++course)
    for (int wale = 0; wale < chart.wales(); ++wale) {
      const Stitch stitch = chart.courses[static_cast<std::size_t>(course)][static_cast<std::size_t>(wale)].stitch;
      const int own_course = (course + margin) % 2, own_wale = (wale + 2 * margin) % 3;
      const bool knit = own_wale == 0 || (own_wale == 1 && own_course == 0);
      EXPECT_EQ(stitch, knit ? Stitch::knit : Stitch::purl) << course << ' ' << wale;
      EXPECT_EQ(larger->repeat.holds({course, wale}),
                course >= margin && course < margin + 2 && wale >= margin && wale < margin + 3);
    }
}

/// Every pattern that is there is a repeat as well, unless it says why not.
TEST(Periodic, MayBeAnyFlatPatternWithoutIntarsia) {
  int made = 0, refused = 0;
  for (const std::string file : {"jersey", "garter", "rib_1x1", "seed", "rib_2x2", "moss", "basket", "stripes",
                                 "panels", "picture", "worked_rows", "fig10a", "intarsia_diamond", "fig11a_tube"}) {
    SCOPED_TRACE(file);
    Sources sources;
    Diagnostics say;
    ChartOverrides overrides;
    overrides.periodic = true;
    const Source* source = sources.read(WALE_SOURCE_DIR "/patterns/" + file + ".yaml");
    ASSERT_NE(source, nullptr);
    const auto chart = compile_chart(*source, overrides, segments_per_stitch, say);
    ++(chart ? made : refused);
    EXPECT_EQ(chart.has_value(), !say.failed());
    for (const Diagnostic& one : say.all()) {
      EXPECT_TRUE(one.code == "C014" || one.code == "C023") << print(one);
      EXPECT_FALSE(one.hint.empty());
    }
  }
  EXPECT_EQ(made, 12);
  EXPECT_EQ(refused, 2);
}

TEST(Periodic, MayBeTensOfStitches) {
  Chart chart = make_random_chart(30, 24, Form::flat, 5);
  chart.periodic = true;
  const CompiledChart made = compiled(chart);
  const Fabric fabric = tiled(made);
  EXPECT_TRUE(check_crossings(fabric, made.crossings, fabric.points).intact());
}

TEST(Periodic, TakesOtherNumbersOfSegments) {
  for (const int segments : {8, 25}) {
    const Fabric fabric = compiled(repeat_of({"pk", "kp"}), segments).fabric;
    EXPECT_EQ(fabric.segment_count(), 4 * segments);
  }
}

}  // namespace
}  // namespace wale
