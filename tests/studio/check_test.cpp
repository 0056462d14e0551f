#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/studio/shell.hpp"

namespace wale::test {
namespace {

const std::string jersey = R"(knit: 1
name: small jersey
wales: 3
yarns:
  main: {material: acrylic_16_2}
bands:
  - {stitch: jersey, courses: 4}
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

TEST(Check, PassesAGoodChart) {
  const Scratch scratch;
  const Answer answer = wale({"check", scratch.write("jersey.yaml", jersey)});
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(answer.err, "");
}

TEST(Check, CountsLoopsAndEdgesAsJson) {
  const Scratch scratch;
  const Answer answer = wale({"check", "--json", "--loops", scratch.write("jersey.yaml", jersey)});
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const auto report = nlohmann::json::parse(answer.out);
  EXPECT_EQ(report["kind"], "chart");
  EXPECT_EQ(report["wales"], 3);
  EXPECT_EQ(report["courses"], 4);
  EXPECT_EQ(report["loops"], 12) << "the swatch's own loops";
  EXPECT_EQ(report["edges"], 9) << "each but the first course through the one below";
  EXPECT_EQ(report["loop_list"].size(), report["loops"]);
  EXPECT_EQ(report["carriers_in"], 0);
  EXPECT_TRUE(report["diagnostics"].empty());
}

TEST(Check, ReportsEveryFileAndAnswersWithTheWorst) {
  const Scratch scratch;
  const std::string good = scratch.write("good.yaml", jersey);
  const std::string bad = scratch.write("bad.yaml", replaced(jersey, "wales: 3", "wales: -3"));
  const Answer answer = wale({"check", bad, good});
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.err.find("bad.yaml:3:"), std::string::npos) << answer.err;
  EXPECT_NE(answer.out.find("good.yaml"), std::string::npos) << answer.out;
}

TEST(Check, SaysWhenAFileCannotBeRead) {
  const Answer answer = wale({"check", "/nonexistent/chart.yaml"});
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_EQ(answer.err.find("/nonexistent/chart.yaml: error: cannot be read"), 0u) << answer.err;
}

struct Mistake {
  std::string what, good, bad;
};

class BadChart : public testing::TestWithParam<Mistake> {};

TEST_P(BadChart, IsOneLineWithItsPlaceAndAHintAndWritesNothing) {
  const Scratch scratch;
  const std::string chart = scratch.write("chart.yaml", replaced(jersey, GetParam().good, GetParam().bad));
  const Answer answer = wale({"compile", chart, "-o", scratch.path("yarns.obj")});
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_TRUE(std::regex_search(answer.first_error_line(), std::regex(R"(chart\.yaml:\d+:\d+: error: .*\[\w+\]$)")))
      << answer.err;
  EXPECT_NE(answer.err.find("\n  hint: "), std::string::npos) << answer.err;
  EXPECT_EQ(scratch.names(), std::vector<std::string>{"chart.yaml"});
}

INSTANTIATE_TEST_SUITE_P(
    EachMistake, BadChart,
    testing::Values(Mistake{"UnknownKey", "wales: 3", "wales: 3\nwails: 3"},
                    Mistake{"UnknownStitch", "stitch: jersey", "stitch: jersy"},
                    Mistake{"RaggedRows", "{stitch: jersey, courses: 4}", "{stitch: \"kkk\\nkk\", courses: 2}"},
                    Mistake{"UnknownSymbol", "{stitch: jersey, courses: 4}", "{stitch: \"kk?\\nkkk\", courses: 2}"},
                    Mistake{"NoUnit", "name: small jersey", "stitch_length: 7.23"},
                    Mistake{"WrongDimension", "name: small jersey", "stitch_length: 7.23 MPa"},
                    Mistake{"NegativeLength", "name: small jersey", "stitch_length: -7.23 mm"},
                    Mistake{"AbsurdLength", "name: small jersey", "stitch_length: 7.23 km"},
                    Mistake{"ZeroCourses", "courses: 4", "courses: 0"},
                    Mistake{"TooManyWales", "wales: 3", "wales: 300000000"},
                    Mistake{"UnknownMaterial", "acrylic_16_2", "acrylic_16"}),
    [](const auto& name) { return name.param.what; });

}  // namespace
}  // namespace wale::test
