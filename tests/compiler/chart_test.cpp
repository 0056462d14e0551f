#include "compiler/chart.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "compiler/front/stitch_patterns.hpp"
#include "compiler/passes.hpp"

namespace wale {
namespace {

struct Parsed {
  Sources sources;
  Diagnostics say;
  std::optional<Chart> chart;
};

Parsed parse(const std::string& text, const ChartOverrides& overrides = {}) {
  Parsed result;
  result.chart = passes::parse_chart(*result.sources.add("chart.yaml", text), overrides, result.say);
  for (const Diagnostic& one : result.say.all()) {
    if (one.severity == Severity::error) ADD_FAILURE() << print(one);
  }
  return result;
}

/// The rows as one would draw them: last line is the first course.
std::vector<std::string> drawn(const Chart& chart) {
  std::vector<std::string> rows;
  for (auto course = chart.courses.rbegin(); course != chart.courses.rend(); ++course) {
    rows.emplace_back();
    for (const Cell& cell : *course) rows.back() += cell.stitch == Stitch::knit ? 'k' : 'p';
  }
  return rows;
}

/// The first letters of the yarns, as drawn.
std::vector<std::string> drawn_yarns(const Chart& chart) {
  std::vector<std::string> rows;
  for (auto course = chart.courses.rbegin(); course != chart.courses.rend(); ++course) {
    rows.emplace_back();
    for (const Cell& cell : *course) rows.back() += chart.yarns[static_cast<std::size_t>(cell.yarn)].name[0];
  }
  return rows;
}

using Rows = std::vector<std::string>;

Rows times(int n, const std::string& row) { return Rows(static_cast<std::size_t>(n), row); }

Rows stacked(std::initializer_list<Rows> top_first) {
  Rows all;
  for (const Rows& rows : top_first) all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

Rows stitches_of(const std::string& stitch, int wales, int courses) {
  const auto parsed = parse("knit: 1\nwales: " + std::to_string(wales) + "\nbands:\n  - {stitch: " + stitch +
                            ", courses: " + std::to_string(courses) + "}\n");
  return parsed.chart ? drawn(*parsed.chart) : Rows{};
}

TEST(Chart, KnowsTheBasicStructures) {
  EXPECT_EQ(stitches_of("jersey", 3, 2), (Rows{"kkk", "kkk"}));
  EXPECT_EQ(stitches_of("stockinette", 3, 1), (Rows{"kkk"}));
  EXPECT_EQ(stitches_of("reverse", 3, 1), (Rows{"ppp"}));
  EXPECT_EQ(stitches_of("purl", 3, 1), (Rows{"ppp"}));
  EXPECT_EQ(stitches_of("garter", 2, 3), (Rows{"kk", "pp", "kk"}));
  EXPECT_EQ(stitches_of("garter 2x1", 1, 6), (Rows{"p", "k", "k", "p", "k", "k"}));
  EXPECT_EQ(stitches_of("rib 1x1", 5, 2), (Rows{"kpkpk", "kpkpk"}));
  EXPECT_EQ(stitches_of("rib 2x1", 7, 1), (Rows{"kkpkkpk"}));
  EXPECT_EQ(stitches_of("Rib_3x2", 6, 1), (Rows{"kkkppk"}));
  EXPECT_EQ(stitches_of("seed", 4, 3), (Rows{"pkpk", "kpkp", "pkpk"}));
  EXPECT_EQ(stitches_of("moss", 4, 5), (Rows{"pkpk", "kpkp", "kpkp", "pkpk", "pkpk"}));
  EXPECT_EQ(stitches_of("basket 2x1", 5, 3), (Rows{"kkppk", "ppkkp", "kkppk"}));
}

TEST(Chart, ListsNoStructureThatItDoesNotKnow) {
  for (const std::string_view name : built_in_stitch_names()) EXPECT_TRUE(built_in_stitch(name)) << name;
  for (const char* name : {"rib", "rib 0x1", "rib 1x", "rib x1", "rib 1x1x1", "rib 99999x1", "seed 2x2", ""}) {
    EXPECT_FALSE(built_in_stitch(name)) << name;
  }
}

TEST(Chart, StacksBandsInKnittingOrder) {
  const auto parsed =
      parse("knit: 1\nwales: 2\nbands:\n  - {stitch: jersey, courses: 2}\n  - {stitch: purl, courses: 1}\n");
  EXPECT_EQ(drawn(*parsed.chart), (Rows{"pp", "kk", "kk"}));
}

TEST(Chart, PutsPanelsSideBySideAndRestartsTheirPatterns) {
  const auto parsed = parse(R"(knit: 1
wales: 7
bands:
  - {stitch: jersey, courses: 1}
  - courses: 2
    panels:
      - {stitch: rib 1x1, wales: 3}
      - {stitch: garter, wales: 4}
)");
  EXPECT_EQ(drawn(*parsed.chart), (Rows{"kpkpppp", "kpkkkkk", "kkkkkkk"}));
}

TEST(Chart, TilesAPictureFromTheLowerLeftCorner) {
  const auto parsed = parse(R"(knit: 1
wales: 5
bands:
  - courses: 3
    stitch: |
      kkp
      pkk
)");
  EXPECT_EQ(drawn(*parsed.chart), (Rows{"pkkpk", "kkpkk", "pkkpk"}));
}

TEST(Chart, TakesItsSizeFromAPicture) {
  const auto parsed = parse("knit: 1\nbands:\n  - stitch: |\n      kp x2\n      pk  # first\n");
  EXPECT_EQ(drawn(*parsed.chart), (Rows{"kp", "kp", "pk"}));
}

TEST(Chart, ReadsSymbolsOfItsLegend) {
  const auto parsed = parse("knit: 1\nsymbols: {\"-\": purl, \"•\": knit}\nbands:\n  - stitch: |\n      --•• k\n");
  EXPECT_EQ(drawn(*parsed.chart), (Rows{"ppkkk"}));
  const Span& third = parsed.chart->courses[0][2].span;
  EXPECT_EQ(third.source->text.substr(third.begin, third.end - third.begin), "•");
}

TEST(Chart, UsesNamedPatterns) {
  const auto parsed =
      parse("knit: 1\nwales: 4\npatterns:\n  ladder: |\n    kp\n    kk x2\nbands:\n  - {stitch: ladder, courses: 4}\n");
  EXPECT_EQ(drawn(*parsed.chart), (Rows{"kkkk", "kpkp", "kkkk", "kkkk"}));
}

TEST(Chart, ChangesYarnsByBandListPanelAndPicture) {
  const auto parsed = parse(R"(knit: 1
wales: 4
yarns: {a: , b: , long: {symbol: c}}
bands:
  - {stitch: jersey, courses: 1, yarn: long}
  - {stitch: jersey, courses: 3, yarn: [a, b]}
  - courses: 1
    yarn: a
    panels: [{stitch: jersey, wales: 1}, {stitch: jersey, wales: 3, yarn: b}]
  - stitch: rib 2x2
    yarn: |
      abba
      caab
)");
  EXPECT_EQ(drawn_yarns(*parsed.chart), (Rows{"abba", "laab", "abbb", "aaaa", "bbbb", "aaaa", "llll"}));
}

TEST(Chart, AYarnPictureRunsOnFromPanelToPanel) {
  const auto parsed = parse(R"(knit: 1
wales: 4
yarns: {a: , b: }
bands:
  - panels: [{stitch: jersey, wales: 1}, {stitch: purl, wales: 3}]
    yarn: |
      aabb
)");
  EXPECT_EQ(drawn(*parsed.chart), (Rows{"kppp"}));
  EXPECT_EQ(drawn_yarns(*parsed.chart), (Rows{"aabb"}));
}

TEST(Chart, TheNearestStitchLengthCounts) {
  const auto parsed = parse(R"(knit: 1
wales: 1
stitch_length: 8 mm
yarns: {a: , b: {stitch_length: 9 mm}}
bands:
  - {stitch: jersey, courses: 1, yarn: a}
  - {stitch: jersey, courses: 1, yarn: b}
  - {stitch: jersey, courses: 1, yarn: b, stitch_length: 10 mm}
)");
  EXPECT_DOUBLE_EQ(parsed.chart->courses[0][0].stitch_length, 8e-3);
  EXPECT_DOUBLE_EQ(parsed.chart->courses[1][0].stitch_length, 9e-3);
  EXPECT_DOUBLE_EQ(parsed.chart->courses[2][0].stitch_length, 10e-3);
}

double stitch_length_of(const std::string& line) {
  const auto parsed = parse("knit: 1\nwales: 1\n" + line + "bands:\n  - {stitch: jersey, courses: 1}\n");
  return parsed.chart ? parsed.chart->courses[0][0].stitch_length : 0;
}

// Munden: 5.5 and 4.2 are stitch length times courses and wales per length.
TEST(Chart, FindsTheStitchLengthOfAGauge) {
  EXPECT_DOUBLE_EQ(stitch_length_of(""), 7.23e-3);
  EXPECT_DOUBLE_EQ(stitch_length_of("gauge: {stitch_length: 8 mm, wales_per_10cm: 28}\n"), 8e-3);
  EXPECT_NEAR(stitch_length_of("gauge: {courses_per_10cm: 55}\n"), 10e-3, 1e-12);
  EXPECT_NEAR(stitch_length_of("gauge: {wales_per_10cm: 42}\n"), 10e-3, 1e-12);
  EXPECT_NEAR(stitch_length_of("gauge: {wales_per_10cm: 42, courses_per_10cm: 55}\n"), 10e-3, 1e-12);
}

TEST(Chart, ReadsFormEdgesAndFirstRow) {
  const auto parsed = parse(
      "knit: 1\nname: sleeve\nform: tube\nwales: 4\nfirst_row: left_to_right\nedges: {start: open, end: open, sides: "
      "free}\n"
      "bands:\n  - {stitch: jersey, courses: 1}\n");
  EXPECT_EQ(parsed.chart->name, "sleeve");
  EXPECT_EQ(parsed.chart->form, Form::tube);
  EXPECT_EQ(parsed.chart->first_course_from, Side::left);
  EXPECT_EQ(parsed.chart->start, Edge::open);
  EXPECT_EQ(parsed.chart->end, Edge::open);
}

const std::string worked = R"(bands:
  - stitch: |
      kkp
      kkp
      kkp
)";

TEST(Chart, WorkedRowsAreTurnedWhereTheKnitterSeesTheBack) {
  EXPECT_EQ(drawn(*parse("knit: 1\nview: worked\n" + worked).chart), (Rows{"kkp", "ppk", "kkp"}));
  EXPECT_EQ(drawn(*parse("knit: 1\nview: worked\nfirst_row: left_to_right\n" + worked).chart),
            (Rows{"ppk", "kkp", "ppk"}));
  EXPECT_EQ(drawn(*parse("knit: 1\nview: worked\nform: tube\n" + worked).chart), (Rows{"kkp", "kkp", "kkp"}));
  EXPECT_EQ(drawn(*parse("knit: 1\nview: face\n" + worked).chart), (Rows{"kkp", "kkp", "kkp"}));
}

TEST(Chart, WorkedRowsLeaveNamedStructuresAlone) {
  const auto parsed = parse("knit: 1\nwales: 1\nview: worked\nbands:\n  - {stitch: jersey, courses: 2}\n");
  EXPECT_EQ(drawn(*parsed.chart), (Rows{"k", "k"}));
}

TEST(Chart, EveryCellKnowsItsPlaceInTheText) {
  const auto parsed = parse(R"(knit: 1
wales: 4
yarns: {a: , b: }
bands:
  - {stitch: jersey, courses: 1}
  - stitch: |
      kkpp
      ppkk
  - stitch: rib 2x2
    yarn: |
      abab
)");
  const auto place = [&](int course, int wale) {
    const LineColumn at =
        locate(parsed.chart->courses[static_cast<std::size_t>(course)][static_cast<std::size_t>(wale)].span);
    return std::pair{at.line, at.column};
  };
  EXPECT_EQ(place(0, 3), std::pair(5, 14));
  EXPECT_EQ(place(1, 0), std::pair(8, 7));
  EXPECT_EQ(place(2, 3), std::pair(7, 10));
  EXPECT_EQ(place(3, 2), std::pair(11, 9));
}

TEST(Chart, IsStretchedByItsScene) {
  const std::string text = "knit: 1\nwales: 4\nbands:\n  - {stitch: seed, courses: 2}\n";
  ChartOverrides overrides;
  overrides.wales = 3;
  overrides.courses = 3;
  overrides.stitch_length = 8e-3;
  overrides.materials.otherwise = Material{.name = "other", .diameter = 0.4e-3};
  const auto parsed = parse(text, overrides);
  EXPECT_EQ(drawn(*parsed.chart), (Rows{"pkp", "kpk", "pkp"}));
  EXPECT_DOUBLE_EQ(parsed.chart->courses[0][0].stitch_length, 8e-3);
  EXPECT_EQ(parsed.chart->yarns[0].material.name, "other");
  EXPECT_TRUE(parsed.say.all().empty());
}

TEST(Chart, OfSeveralBandsMayBeAskedForItsOwnHeight) {
  const std::string text =
      "knit: 1\nwales: 4\nbands:\n  - {stitch: seed, courses: 2}\n  - {stitch: jersey, courses: 3}\n";
  ChartOverrides overrides;
  overrides.courses = 5;
  EXPECT_EQ(parse(text, overrides).chart->course_count(), 5);
}

TEST(Chart, WarnsOnceOfAYarnThatIsTooThick) {
  const std::string text =
      "knit: 1\nwales: 4\nyarns: {main: paper-as-printed}\nbands:\n  - {stitch: seed, courses: 9}\n";
  const auto parsed = parse(text);
  ASSERT_EQ(parsed.say.all().size(), 1u);
  EXPECT_EQ(parsed.say.all()[0].severity, Severity::warning);
  EXPECT_NE(parsed.say.all()[0].message.find("6.90"), std::string::npos);
}

TEST(Chart, PrintsWithCourseNumbersAndDirections) {
  const auto parsed =
      parse("knit: 1\nname: n\nyarns: {red: , b: }\nbands:\n  - stitch: |\n      kp\n      pk\n    yarn: [red, b]\n");
  EXPECT_EQ(print(*parsed.chart),
            "n: flat, 2 wales x 2 courses, cast on to bind off\n"
            "yarn a = red: acrylic_16_2, contact diameter 0.524 mm, 77 tex\n"
            "yarn b = b: acrylic_16_2, contact diameter 0.524 mm, 77 tex\n"
            "    2 -> kp  bb  7.23 mm\n"
            "    1 <- pk  aa  7.23 mm\n");
}

TEST(Chart, NoChangeOfACharacterMakesItThrow) {
  const std::string good =
      "knit: 1\nwales: 2\nyarns: {a: , b: {stitch_length: 8 mm}}\nsymbols: {v: purl}\nbands:\n"
      "  - {stitch: rib 1x1, courses: 2, yarn: [a]}\n  - stitch: |\n      kv x2\n    yarn: |\n      ab\n";
  std::mt19937 random(7);
  for (int trial = 0; trial < 4000; ++trial) {
    Sources sources;
    std::string text = good;
    for (int i = 0; i < 2; ++i) text[random() % text.size()] = "kx09 -:,{}[]|>#\n\"'%ab\xc3"[random() % 22];
    Diagnostics say;
    const Source* source = sources.add("chart.yaml", text);
    std::optional<Chart> chart;
    ASSERT_NO_THROW(chart = passes::parse_chart(*source, {}, say)) << text;
    EXPECT_EQ(chart.has_value(), !say.failed()) << text;
    for (const Diagnostic& one : say.all()) ASSERT_NO_THROW(print(one)) << text;
  }
}

struct Shared {
  const char* file;
  Rows stitches, yarns;
};

/// The seven worked examples, expanded by hand.
TEST(Chart, ExpandsTheWorkedExamplesAsTheyAreMeant) {
  const std::string folder = WALE_SHARED_DIR "/charts/B_blocks/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared folder here";
  const std::string k(12, 'k'), p(12, 'p'), m(12, 'm');
  const Rows garter{p, k, p, k, p, k};
  const std::vector<Shared> examples{
      {"jersey.yaml", times(13, k), times(13, m)},
      {"fig10a.yaml", stacked({garter, times(6, k)}), times(12, m)},
      {"fig10b.yaml", stacked({times(3, k), garter, times(3, k)}), times(12, m)},
      {"fig10c.yaml", stacked({times(6, "kpkpkpkpkpkp"), garter}), times(12, m)},
      {"fig11_tube.yaml", times(24, std::string(20, 'k')), times(24, std::string(20, 's'))},
      {"rib_intarsia.yaml",
       times(10, "kkppkkppkkppkkpp"),
       {"aaaaaaaaaaaaaaaa", "aaaaaaaaaaaaaaaa", "aaaaaaabbaaaaaaa", "aaaaaabbbbaaaaaa", "aaaaabbbbbbaaaaa",
        "aaaaabbbbbbaaaaa", "aaaaaabbbbaaaaaa", "aaaaaaabbaaaaaaa", "aaaaaaaaaaaaaaaa", "aaaaaaaaaaaaaaaa"}},
  };
  for (const Shared& example : examples) {
    Sources sources;
    Diagnostics say;
    const Source* source = sources.read(folder + example.file);
    ASSERT_NE(source, nullptr) << example.file;
    const auto chart = passes::parse_chart(*source, {}, say);
    ASSERT_TRUE(chart) << example.file;
    EXPECT_TRUE(say.all().empty()) << example.file;
    EXPECT_EQ(drawn(*chart), example.stitches) << example.file;
    EXPECT_EQ(drawn_yarns(*chart), example.yarns) << example.file;
  }
}

TEST(Chart, TheStiffYarnOfTheTubeIsTenTimesAsStiff) {
  Sources sources;
  Diagnostics say;
  const Source* source = sources.read(WALE_SOURCE_DIR "/patterns/fig11a_tube.yaml");
  ASSERT_NE(source, nullptr);
  const auto chart = passes::parse_chart(*source, {}, say);
  ASSERT_TRUE(chart);
  const std::vector<int> bands{0, 5, 6, 17, 18, 23}, yarns{0, 0, 1, 1, 0, 0};
  for (std::size_t i = 0; i < bands.size(); ++i)
    EXPECT_EQ(chart->courses[static_cast<std::size_t>(bands[i])][0].yarn, yarns[i]);
  EXPECT_NEAR(chart->yarns[0].material.axial_stiffness / chart->yarns[1].material.axial_stiffness, 10, 0.02);
  EXPECT_NEAR(chart->yarns[0].material.bending_rigidity / chart->yarns[1].material.bending_rigidity, 10, 0.02);
}

}  // namespace
}  // namespace wale
