#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <tuple>

#include "sim/results/hdf5.hpp"
#include "tests/studio/shell.hpp"

namespace wale::test {
namespace {

namespace fs = std::filesystem;

const std::string chart = R"(knit: 1
wales: 3
yarns: {main: {material: acrylic_16_2}}
bands: [{stitch: jersey, courses: 4}]
)";

/// In time rather than at equilibria: many small, quick steps, so that an interruption falls between two samples.
const std::string scene = R"(scene: 1
fabric: {pattern: chart.yaml, segments_per_stitch: 10}
effects: {stretch: , bend: , contact: , drag: }
stages:
  - {name: tighten, duration: 5 us, samples: 1, tighten: 10 %, hold: ends}
  - {name: pull, duration: 160 us, samples: 8, pull: {along: wale, to: 4 %}}
solver: {runge_kutta: {relative: 1e-3}}
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

class Run : public testing::Test {
 protected:
  Run() { scratch_.write("chart.yaml", chart); }
  std::string folder() const { return scratch_.path("results"); }
  std::string file(const std::string& name) const { return folder() + "/" + name; }
  Answer run(const std::string& text) const {
    return wale({"run", scratch_.write("scene.yaml", text), "-o", folder()});
  }
  Scratch scratch_;
};

TEST_F(Run, LeavesEveryFileThatItPromises) {
  const Answer answer = run(scene);
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  for (const char* name : {"curve.csv", "summary.json", "results.h5", "frames.pvd", "fabric_relaxed.svg",
                           "fabric_pulled.svg", "curve.svg"})
    EXPECT_TRUE(fs::is_regular_file(file(name))) << name;
  EXPECT_TRUE(read(file("curve.csv")).starts_with("strain,stress_MPa,force_N,force_per_wale_N,"))
      << read(file("curve.csv"));
  EXPECT_EQ(numbers(read(file("curve.csv"))).size(), 9u) << "the start of the pull and its eight samples";
  const auto summary = nlohmann::json::parse(read(file("summary.json")));
  EXPECT_TRUE(summary["topology"]["intact"].get<bool>());
  EXPECT_EQ(wale({"curve", folder()}).out, read(file("curve.csv")));
}

TEST_F(Run, GoesOnAfterAnInterruptionToTheCurveOfAnUninterruptedRun) {
  ASSERT_EQ(run(scene).exit_code, 0);
  const std::string whole = read(file("curve.csv"));

  const std::string other = scratch_.path("interrupted");
  const Answer stopped = wale({"run", scratch_.path("scene.yaml"), "-o", other}, other + "/results.h5");
  ASSERT_EQ(stopped.exit_code, 130) << stopped.err;
  EXPECT_NE(stopped.err.find("wale run --resume " + other), std::string::npos) << stopped.err;
  fs::remove(scratch_.path("scene.yaml"));
  fs::remove(scratch_.path("chart.yaml"));
  EXPECT_LT(numbers(read(other + "/curve.csv")).size(), 9u) << "it was stopped too late to show anything";
  const Answer resumed = wale({"run", "--resume", other});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;

  EXPECT_EQ(read(other + "/curve.csv"), whole);
}

TEST_F(Run, GoesOnBetweenEquilibriaToTheSameCurve) {
  const std::string still = R"(scene: 1
fabric: {pattern: chart.yaml, segments_per_stitch: 10}
effects: {stretch: , bend: , contact: , knots: }
stages:
  - {name: tighten, duration: 1 s, samples: 1, tighten: 60 %, hold: ends, solver: {quasi_static: {tolerance: 1}}}
  - {name: mount, duration: 1 s, samples: 4, mount: wale}
  - {name: pull, duration: 1 s, samples: 5, pull: {along: wale, to: 10 %}}
solver: {quasi_static: {tolerance: 0.02, first_step: 5 %}}
)";
  ASSERT_EQ(run(still).exit_code, 0);
  const auto whole = numbers(read(file("curve.csv")));

  const std::string other = scratch_.path("interrupted");
  const Answer stopped = wale({"run", scratch_.path("scene.yaml"), "-o", other}, other + "/results.h5");
  ASSERT_EQ(stopped.exit_code, 130) << stopped.err;
  const Answer resumed = wale({"run", "--resume", other});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;

  const auto mended = numbers(read(other + "/curve.csv"));
  ASSERT_EQ(mended.size(), whole.size());
  const double strongest = whole.back()[2];  // N
  ASSERT_GT(strongest, 1e-3);
  for (std::size_t row = 0; row < whole.size(); ++row)
    EXPECT_NEAR(mended[row][2], whole[row][2], 2e-3 * strongest) << row;
}

const std::string cell = R"(scene: 1
fabric: {pattern: chart.yaml, wales: 2, courses: 2, periodic: true, segments_per_stitch: 10}
effects: {stretch: , bend: , contact: , friction: }
stages:
  - {name: tighten, duration: 1 s, samples: 4, tighten: 100 %}
  - {name: relax, duration: 1 s, samples: 1}
  - {name: pull, duration: 1 s, samples: 160, pull: {along: wale, to: [40 %, 0 %]}}
)";

TEST_F(Run, OfACellGoesOnWithTheSameBits) {
  ASSERT_EQ(run(cell).exit_code, 0);
  const std::string other = scratch_.path("interrupted");
  const Answer stopped = wale({"run", scratch_.path("scene.yaml"), "-o", other}, other + "/results.h5");
  ASSERT_EQ(stopped.exit_code, 130) << stopped.err;
  EXPECT_LT(numbers(read(other + "/curve.csv")).size(), 161u) << "it was stopped too late to show anything";
  const Answer resumed = wale({"run", "--resume", other});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(read(other + "/curve.csv"), read(file("curve.csv")));
  EXPECT_EQ(read(other + "/fabric_pulled.svg"), read(file("fabric_pulled.svg")));
}

std::size_t residual_column(const std::string& table) {
  const std::string before = table.substr(0, table.find("residual_N"));
  return static_cast<std::size_t>(std::count(before.begin(), before.end(), ','));
}

TEST_F(Run, TellsHowNearlyForcesBalance) {
  const Answer answer = run(replaced(cell, "samples: 160", "samples: 4"));
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const std::string table = read(file("curve.csv"));
  EXPECT_TRUE(table.starts_with("strain,stress_MPa,force_N,force_per_wale_N,")) << table;
  const std::size_t column = residual_column(table);
  const auto balance = nlohmann::json::parse(read(file("summary.json")))["balance"];
  const auto rows = numbers(table);
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_TRUE(std::isnan(rows[0][column])) << "the pull has not moved yet";
  double most = 0;
  for (std::size_t row = 1; row < rows.size(); ++row) most = std::max(most, rows[row][column]);
  EXPECT_GT(most, 0);
  EXPECT_LT(most, balance["pull"]["tolerance_N"].get<double>());
  EXPECT_NEAR(balance["pull"]["residual_N"].get<double>(), most, 1e-6 * most);
  EXPECT_GT(balance["pull"]["residual_over_load"].get<double>(), 0);
  EXPECT_TRUE(balance["relax"]["residual_over_load"].is_null());
  EXPECT_NE(answer.out.find("of the largest load on a wale"), std::string::npos) << answer.out;
}

/// Along the courses a cell bears little: a residual that is small beside EI/d² would be a fifth of that.
TEST_F(Run, BalancesAPullInProportionToItsLoad) {
  std::string along_courses = replaced(cell, "samples: 160", "samples: 6");
  along_courses = replaced(along_courses, "along: wale, to: [40 %, 0 %]", "along: course, to: 40 %");
  for (const double of_load : {1e3, 2e-3}) {
    const std::string solver = fmt::format("solver: {{quasi_static: {{tolerance: 0.3, of_load: {}}}}}\n", of_load);
    ASSERT_EQ(run(along_courses + solver).exit_code, 0);
    const std::string table = read(file("curve.csv"));
    const auto rows = numbers(table);
    const double allowed =
        nlohmann::json::parse(read(file("summary.json")))["balance"]["pull"]["tolerance_N"].get<double>();
    bool any_above = false;
    for (std::size_t row = 1; row < rows.size(); ++row) {
      const double load = rows[row][3], residual = rows[row][residual_column(table)];
      EXPECT_LE(residual, std::clamp(of_load * load, allowed / 20, allowed));
      any_above |= residual > std::clamp(2e-3 * load, allowed / 20, allowed);
    }
    EXPECT_EQ(any_above, of_load > 1) << "tolerance alone does not do it";
  }
}

const std::string program = R"(;!knitout-2
;;Carriers: 1
;;Machine: SWGXYZ
in 1
knit + f0 1
knit + f1 1
knit + f2 1
knit - f2 1
knit - f1 1
knit - f0 1
knit + f0 1
knit + f1 1
knit + f2 1
out 1
)";

/// In the second stage nothing balances as nearly as is asked for.
const std::string hopeless = R"(scene: 1
fabric: {pattern: chart.yaml, segments_per_stitch: 10}
effects: {stretch: , bend: , contact: }
stages:
  - {name: tighten, duration: 1 s, samples: 1, tighten: 20 %, hold: ends, solver: {quasi_static: {tolerance: 1}}}
  - {name: relax, duration: 1 s, samples: 2, solver: {quasi_static: {tolerance: 1e-9, iterations: 1}}}
)";

/// The line of a pattern that a failed run or its resumption blames for the worst residual; 0 if none.
int blamed_line(const Answer& answer, const std::string& pattern) {
  std::smatch found;
  const std::regex place("the solve failed: .* stitch [0-9]+ of [^ ]*" + pattern + ":([0-9]+):[0-9]+ \\(segment");
  return std::regex_search(answer.err, found, place) ? std::stoi(found[1]) : 0;
}

TEST_F(Run, ThatFailsNamesTheLineOfTheStitchAndCanBeResumed) {
  scratch_.write("program.k", program);
  for (const auto& [pattern, first_line, last_line] : {std::tuple{"chart.yaml", 4, 4}, {"program.k", 5, 13}}) {
    SCOPED_TRACE(pattern);
    const Answer answer = run(replaced(hopeless, "chart.yaml", pattern));
    EXPECT_EQ(answer.exit_code, 2);
    EXPECT_GE(blamed_line(answer, pattern), first_line) << answer.err;
    EXPECT_LE(blamed_line(answer, pattern), last_line) << answer.err;
    const auto snapshots = read_hdf5(file("results.h5")).snapshots;
    EXPECT_EQ(snapshots.back().sample, -1) << "how far it got is saved";
    EXPECT_NE(snapshots.back().state.q, snapshots[snapshots.size() - 2].state.q);
    const Answer resumed = wale({"run", "--resume", folder()});
    EXPECT_EQ(resumed.exit_code, 2) << "the scene has not changed";
    EXPECT_GE(blamed_line(resumed, pattern), first_line) << resumed.err;
  }
}

TEST_F(Run, OfADeformationTellsStrainsAndStresses) {
  const std::string pull = cell.substr(cell.find("pull: {along"));
  const Answer answer = run(replaced(cell, pull, "deform: {shear: [5 %, 0 %], course: held}}\n"));
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Answer curve = wale({"curve", folder()});
  EXPECT_TRUE(curve.out.starts_with("strain_wale,stress_wale_MPa,strain_course,stress_course_MPa,strain_shear,"))
      << curve.out;
  EXPECT_EQ(curve.out, read(file("curve.csv")));
  EXPECT_EQ(numbers(curve.out).size(), 161u);
  const auto json = nlohmann::json::parse(wale({"curve", folder(), "--json"}).out);
  EXPECT_EQ(json["shear"]["strain"].size(), 161u);
  EXPECT_TRUE(fs::is_regular_file(file("fabric_pulled.svg")));
  EXPECT_TRUE(fs::is_regular_file(file("curve.svg")));
}

TEST_F(Run, RefusesAFolderThatCannotBeWrittenBeforeItComputes) {
  scratch_.write("results", "a file where the folder should be");
  const Answer answer = run(scene);
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.first_error_line().find("error: cannot be written"), std::string::npos) << answer.err;
}

TEST_F(Run, PrintsTheSummaryAsJson) {
  const std::string tighten_only = replaced(
      scene, scene.substr(scene.find("  - {name: pull"), scene.find("solver:") - scene.find("  - {name: pull")), "");
  const Answer answer =
      wale({"run", scratch_.write("scene.yaml", tighten_only), "-o", folder(), "--json", "--threads", "1"});
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(nlohmann::json::parse(answer.out)["threads"], 1);
}

TEST(Resume, SaysWhenThereIsNothingToGoOnFrom) {
  const Scratch scratch;
  const Answer answer = wale({"run", "--resume", scratch.path("nothing")});
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.err.find("nothing"), std::string::npos) << answer.err;
}

struct Mistake {
  std::string what, good, bad;
};

class BadScene : public Run, public testing::WithParamInterface<Mistake> {};

TEST_P(BadScene, IsOneLineWithItsPlaceAndAHintAndMakesNoFolder) {
  const Answer answer = run(replaced(scene, GetParam().good, GetParam().bad));
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_TRUE(std::regex_search(answer.first_error_line(), std::regex(R"(\.yaml:\d+:\d+: error: .*\[\w+\]$)")))
      << answer.err;
  EXPECT_NE(answer.err.find("\n  hint: "), std::string::npos) << answer.err;
  EXPECT_FALSE(fs::exists(folder()));
}

INSTANTIATE_TEST_SUITE_P(
    EachMistake, BadScene,
    testing::Values(Mistake{"UnknownKey", "effects:", "efects:"}, Mistake{"UnknownEffect", "bend:", "bent:"},
                    Mistake{"NoChart", "chart.yaml", "cart.yaml"}, Mistake{"NoUnit", "duration: 5 us", "duration: 5"},
                    Mistake{"WrongDimension", "duration: 5 us", "duration: 5 mm"},
                    Mistake{"NegativeTime", "duration: 5 us", "duration: -5 us"},
                    Mistake{"StrainWithoutADirection", "pull: {along: wale, to: 4 %}", "pull: 4 %"},
                    Mistake{"StrainInADictionaryWithoutADirection", "along: wale, ", ""},
                    Mistake{"AbsurdSize", "segments_per_stitch: 10", "segments_per_stitch: 10, wales: 100000000"},
                    Mistake{"NoStages", "stages:", "#"}),
    [](const auto& name) { return name.param.what; });

}  // namespace
}  // namespace wale::test
