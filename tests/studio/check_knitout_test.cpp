#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/studio/shell.hpp"
#include "tests/support/shared_files.hpp"
#include "tests/support/table.hpp"

namespace wale::test {
namespace {

using Json = nlohmann::json;

const std::string swatch =
    ";!knitout-2\n;;Carriers: 1 2\nin 1\ntuck - f2 1\ntuck - f1 1\nknit + f1 1\nknit + f2 1\nsplit - f2 b2 1\nout 1\n";

TEST(CheckKnitout, CountsWhatIsKnittedAsJson) {
  const Scratch scratch;
  const Answer answer = wale({"check", "--json", "--loops", scratch.write("swatch.k", swatch)});
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Json report = Json::parse(answer.out);
  EXPECT_EQ(report["kind"], "knitout");
  EXPECT_EQ(report["instructions"], 7);
  EXPECT_EQ(report["loops"], 5);
  EXPECT_EQ(report["edges"], 3);
  EXPECT_EQ(report["knits"], 2);
  EXPECT_EQ(report["tucks"], 2);
  EXPECT_EQ(report["splits"], 1);
  EXPECT_EQ(report["knits_on_empty"], 0);
  EXPECT_EQ(report["on_needles"], (Json{{"f", 2}, {"b", 1}, {"fs", 0}, {"bs", 0}}));
  EXPECT_EQ(report["yarns"], 1);
  EXPECT_EQ(report["carriers_in"], 0);
  EXPECT_EQ(report["courses"], 3);
  EXPECT_EQ(report["wales"], 3);
  EXPECT_EQ(report["loop_list"][4], (Json{{"id", 4},
                                          {"carrier", "1"},
                                          {"direction", "-"},
                                          {"needle", "f2"},
                                          {"line", 8},
                                          {"op", "split"},
                                          {"parents", {3}},
                                          {"previous", 3}}));
}

TEST(CheckKnitout, StillCountsAFileWithErrors) {
  const Scratch scratch;
  const Answer answer = wale({"check", "--json", scratch.write("bad.k", swatch + "xfer f1 f2\nknit + g2 1\n")});
  EXPECT_EQ(answer.exit_code, 1);
  const Json report = Json::parse(answer.out);
  EXPECT_EQ(report["loops"], 5);
  std::vector<std::string> places;
  for (const Json& one : report["diagnostics"])
    if (one["severity"] == "error")
      places.push_back(std::to_string(one["line"].get<int>()) + ":" + std::to_string(one["column"].get<int>()));
  EXPECT_EQ(places, (std::vector<std::string>{"11:8", "10:1"}));
}

TEST(CheckKnitout, AgreesWithTheRecordOfEveryFileOfTheCorpus) {
  const auto rows = read_table(read_text(shared_folder / "corpus/manifest.csv"));
  if (rows.empty()) GTEST_SKIP() << "no corpus beside the checkout";
  std::vector<std::string> arguments{"check", "--json"};
  for (const Row& row : rows) arguments.push_back(shared_folder / "corpus" / row.at("path"));
  const Json reports = Json::parse(wale(arguments).out)["files"];
  ASSERT_EQ(reports.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    SCOPED_TRACE(rows[i].at("path"));
    for (const auto& [key, name] : std::map<std::string, std::string>{{"loops", "loops"},
                                                                      {"edges", "parent_child_edges"},
                                                                      {"knits", "knit_stitches"},
                                                                      {"tucks", "tucks"},
                                                                      {"knits_on_empty", "knit_on_empty"},
                                                                      {"yarns", "yarn_pieces"}})
      EXPECT_EQ(std::to_string(reports[i][key].get<int>()), rows[i].at(name)) << key;
    for (const std::string bed : {"f", "b", "fs", "bs"})
      EXPECT_EQ(std::to_string(reports[i]["on_needles"][bed].get<int>()), rows[i].at("on_" + bed)) << bed;
    EXPECT_EQ(reports[i]["carriers_in"].get<int>() > 0, !rows[i].at("carriers_in_at_end").empty());
  }
}

}  // namespace
}  // namespace wale::test
