#include <gtest/gtest.h>

#include "compiler/passes.hpp"
#include "compiler/passes/program_codes.hpp"
#include "tests/support/make_chart.hpp"

namespace wale {
namespace {

std::optional<StitchGraph> graph_of(const Chart& chart, Diagnostics& say) {
  const auto program = passes::lower_chart(chart, say);
  return program ? passes::knit(*program, say) : std::nullopt;
}

std::optional<Layout> layout_of(const Chart& chart, Diagnostics& say) {
  const auto graph = graph_of(chart, say);
  return graph ? passes::place(*graph, chart, say) : std::nullopt;
}

int sign(Stitch stitch) { return stitch == Stitch::knit ? 1 : -1; }

void expect_faces_of(const Chart& chart) {
  Diagnostics say;
  const auto layout = layout_of(chart, say);
  ASSERT_TRUE(layout);
  EXPECT_TRUE(say.all().empty());
  ASSERT_EQ(layout->rows.size(), chart.courses.size());
  for (int course = 0; course < chart.course_count(); ++course) {
    const int above = std::min(course + 1, chart.course_count() - 1);
    for (int wale = 0; wale < chart.wales(); ++wale) {
      const PlacedLoop& at = layout->rows[static_cast<std::size_t>(course)][static_cast<std::size_t>(wale)];
      const Cell& cell = chart.courses[static_cast<std::size_t>(course)][static_cast<std::size_t>(wale)];
      const Cell& upper = chart.courses[static_cast<std::size_t>(above)][static_cast<std::size_t>(wale)];
      EXPECT_EQ(at.course, course);
      EXPECT_EQ(at.wale, wale);
      EXPECT_EQ(at.sign, sign(cell.stitch)) << course << "," << wale;
      EXPECT_EQ(at.sign_above, sign(upper.stitch)) << course << "," << wale;
      EXPECT_EQ(at.material, cell.yarn);
      EXPECT_EQ(at.stitch_length, cell.stitch_length);
    }
  }
}

std::string refusal(const StitchGraph& graph, const Chart& chart) {
  Diagnostics say;
  EXPECT_FALSE(passes::place(graph, chart, say));
  EXPECT_EQ(say.all().size(), 1u);
  EXPECT_EQ(say.all().front().code, codes::not_placeable);
  return say.all().front().message;
}

TEST(Place, GivesARandomChartBackItsFaces) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const int wales = 1 + static_cast<int>(seed % 9), courses = 1 + static_cast<int>(seed % 7);
    Chart chart = make_random_chart(wales, courses, Form::flat, seed);
    chart.first_course_from = seed % 2 ? Side::left : Side::right;
    expect_faces_of(chart);
  }
}

TEST(Place, GivesARandomTubeBackItsFacesAsSeenFromOutside) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const int wales = 4 + 2 * static_cast<int>(seed % 6), courses = 1 + static_cast<int>(seed % 7);
    Chart chart = make_random_chart(wales, courses, Form::tube, seed);
    chart.first_course_from = seed % 2 ? Side::left : Side::right;
    expect_faces_of(chart);
  }
}

TEST(Place, KeepsTheYarnAndTheLengthOfEveryCell) {
  Chart chart = make_random_chart(6, 5, Form::flat, 3);
  chart.yarns.push_back({"b", Material{}, "#000000"});
  for (std::size_t course = 0; course < chart.courses.size(); ++course)
    for (std::size_t wale = 0; wale < chart.courses[course].size(); ++wale) {
      chart.courses[course][wale].yarn = static_cast<int>((course + wale / 3) % 2);
      chart.courses[course][wale].stitch_length = 5e-3 + 1e-5 * static_cast<double>(7 * course + wale);
    }
  expect_faces_of(chart);
}

TEST(Place, KnitsAFlatFabricToAndFro) {
  Diagnostics say;
  Chart chart = make_chart({"kkk", "kkk", "kkk"});
  EXPECT_EQ(layout_of(chart, say)->from_left, (std::vector<int>{0, 1, 0}));
  chart.first_course_from = Side::left;
  EXPECT_EQ(layout_of(chart, say)->from_left, (std::vector<int>{1, 0, 1}));
}

TEST(Place, KnitsATubeRoundOneWay) {
  Diagnostics say;
  Chart chart = make_chart({"kkkk", "kkkk", "kkkk"}, Form::tube);
  EXPECT_EQ(layout_of(chart, say)->from_left, (std::vector<int>{0, 0, 0}));
  chart.first_course_from = Side::left;
  EXPECT_EQ(layout_of(chart, say)->from_left, (std::vector<int>{1, 1, 1}));
}

TEST(Place, KnowsTheWayOfACourseOfOneStitch) {
  Diagnostics say;
  EXPECT_EQ(layout_of(make_chart({"k", "p"}), say)->from_left, (std::vector<int>{0, 1}));
}

TEST(Place, TakesTheEdgesFromTheChart) {
  Diagnostics say;
  Chart chart = make_chart({"kk"});
  EXPECT_TRUE(layout_of(chart, say)->cast_on && layout_of(chart, say)->bind_off);
  chart.start = chart.end = Edge::open;
  EXPECT_FALSE(layout_of(chart, say)->cast_on || layout_of(chart, say)->bind_off);
}

TEST(Place, RefusesALoopThatIsPulledThroughItsNeighbour) {
  Diagnostics say;
  const Chart chart = make_chart({"kk", "kk"});
  StitchGraph graph = *graph_of(chart, say);
  std::swap(graph.loops[2].through, graph.loops[3].through);
  EXPECT_NE(refusal(graph, chart).find("cannot be placed yet"), std::string::npos);
}

TEST(Place, RefusesALoopThatIsPulledThroughTwo) {
  Diagnostics say;
  const Chart chart = make_chart({"kk", "kk"});
  StitchGraph graph = *graph_of(chart, say);
  graph.loops[2].through = {0, 1};
  EXPECT_NE(refusal(graph, chart).find("exactly the loop below"), std::string::npos);
}

TEST(Place, RefusesALoopWithoutACell) {
  Diagnostics say;
  const Chart chart = make_chart({"kk", "kk"});
  StitchGraph graph = *graph_of(chart, say);
  graph.loops[1].cell = {};
  EXPECT_NE(refusal(graph, chart).find("no cell"), std::string::npos);
}

TEST(Place, RefusesTwoLoopsInOneCell) {
  Diagnostics say;
  const Chart chart = make_chart({"kk"});
  StitchGraph graph = *graph_of(chart, say);
  graph.loops[1].cell = graph.loops[0].cell;
  EXPECT_NE(refusal(graph, chart).find("one cell"), std::string::npos);
}

TEST(Place, RefusesAChartThatIsNotFullAtTheEmptyCell) {
  Diagnostics say;
  const Chart chart = make_chart({"kk", "kk"});
  StitchGraph graph = *graph_of(chart, say);
  graph.loops.pop_back();
  Diagnostics refused;
  EXPECT_FALSE(passes::place(graph, chart, refused));
  ASSERT_EQ(refused.all().size(), 1u);
  EXPECT_EQ(refused.all().front().span.begin, chart.courses[1][1].span.begin);
}

TEST(Place, RefusesACourseKnittedInAnyOrder) {
  Diagnostics say;
  const Chart chart = make_chart({"kkk"});
  StitchGraph graph = *graph_of(chart, say);
  std::swap(graph.loops[0].cell, graph.loops[1].cell);
  EXPECT_NE(refusal(graph, chart).find("out of order"), std::string::npos);
}

TEST(Place, RefusesATuck) {
  Diagnostics say;
  const Chart chart = make_chart({"kk"});
  StitchGraph graph = *graph_of(chart, say);
  graph.loops[1].kind = LoopKind::tuck;
  EXPECT_NE(refusal(graph, chart).find("tuck"), std::string::npos);
}

TEST(Place, PrintsOneLoopALine) {
  Diagnostics say;
  EXPECT_EQ(print(*layout_of(make_chart({"p", "k"}), say)),
            "flat of 1 wales x 2 courses, cast on, bound off\n"
            "course 1 from the right\n"
            "  wale 1: loop 0 knit, above it purl, yarn 0, 7.23 mm\n"
            "course 2 from the left\n"
            "  wale 1: loop 1 purl, above it purl, yarn 0, 7.23 mm\n");
}

}  // namespace
}  // namespace wale
