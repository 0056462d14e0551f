#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compiler/passes.hpp"
#include "tests/support/shared_files.hpp"
#include "tests/support/table.hpp"

namespace wale {
namespace {

struct Knitted {
  Source source;
  Diagnostics say;
  Program program;
  StitchGraph graph;
};

std::unique_ptr<Knitted> knit(const std::string& path) {
  auto made = std::make_unique<Knitted>();
  made->source = {path, read_text(path)};
  made->program = passes::parse_knitout(made->source, made->say);
  made->graph = passes::knit_all(made->program);
  return made;
}

long on(const StitchGraph& graph, Bed bed) {
  long count = 0;
  for (const HeldLoops& each : graph.on_needles)
    if (each.needle.bed == bed) count += static_cast<long>(each.loops.size());
  return count;
}

/// Names of those that came in and did not go out, as the table writes them.
std::string carriers_in(const Program& program) {
  std::vector<bool> in(program.carriers.size());
  for (const Instruction& at : program.code) {
    const bool comes = at.op == Op::in || at.op == Op::inhook, goes = at.op == Op::out || at.op == Op::outhook;
    if (comes || goes)
      for (const int carrier : at.carriers) in[static_cast<std::size_t>(carrier)] = comes;
  }
  std::string names;
  for (std::size_t i = 0; i < in.size(); ++i)
    if (in[i]) names += (names.empty() ? "" : " ") + program.carriers[i];
  return names;
}

Row counts(const Knitted& knitted) {
  const StitchGraph& graph = knitted.graph;
  std::size_t edges = 0, tucks = 0, splits = 0, on_empty = 0;
  for (const Loop& loop : graph.loops) {
    edges += loop.through.size();
    tucks += loop.kind == LoopKind::tuck;
    on_empty += loop.kind == LoopKind::knit && loop.through.empty();
    splits += !loop.through.empty() && knitted.program.code[static_cast<std::size_t>(loop.instruction)].op == Op::split;
  }
  return {{"loops", std::to_string(graph.loops.size())},
          {"parent_child_edges", std::to_string(edges)},
          {"knit_stitches", std::to_string(graph.loops.size() - tucks - splits - on_empty)},
          {"tucks", std::to_string(tucks)},
          {"knit_on_empty", std::to_string(on_empty)},
          {"on_f", std::to_string(on(graph, Bed::front))},
          {"on_b", std::to_string(on(graph, Bed::back))},
          {"on_fs", std::to_string(on(graph, Bed::front_slider))},
          {"on_bs", std::to_string(on(graph, Bed::back_slider))},
          {"yarn_pieces", std::to_string(graph.yarns.size())},
          {"carriers_in_at_end", carriers_in(knitted.program)}};
}

TEST(KnitoutCorpus, GivesTheRecordedCounts) {
  const auto rows = read_table(read_text(shared_folder / "corpus/manifest.csv"));
  if (rows.empty()) GTEST_SKIP() << "no corpus beside the checkout";
  for (const Row& row : rows) {
    const auto knitted = knit(shared_folder / "corpus" / row.at("path"));
    for (const auto& [name, value] : counts(*knitted)) EXPECT_EQ(value, row.at(name)) << row.at("path") << ": " << name;
    EXPECT_EQ(knitted->say.failed(), row.at("parse_errors") != "0") << row.at("path");
  }
}

TEST(KnitoutCorpus, MakesTheRecordedLoops) {
  if (!std::filesystem::exists(shared_folder / "corpus/loopgraphs.json")) GTEST_SKIP() << "no corpus";
  const auto graphs = nlohmann::json::parse(read_text(shared_folder / "corpus/loopgraphs.json"));
  for (const auto& [path, recorded] : graphs.items()) {
    SCOPED_TRACE(path);
    const auto knitted = knit(shared_folder / "corpus" / path);
    const StitchGraph& graph = knitted->graph;
    ASSERT_EQ(graph.loops.size(), recorded["loops"].size());
    Locator locate_loop;
    std::vector<int> previous(graph.loops.size(), -1);
    for (const YarnPath& yarn : graph.yarns)
      for (std::size_t i = 1; i < yarn.loops.size(); ++i)
        previous[static_cast<std::size_t>(yarn.loops[i])] = yarn.loops[i - 1];
    for (std::size_t i = 0; i < graph.loops.size(); ++i) {
      const Loop& loop = graph.loops[i];
      const auto& wanted = recorded["loops"][i];
      std::vector<int> through = loop.through, parents = wanted["parents"];
      std::sort(through.begin(), through.end());
      std::sort(parents.begin(), parents.end());
      EXPECT_EQ(graph.carriers[static_cast<std::size_t>(loop.carrier)], wanted["carrier"]) << i;
      EXPECT_EQ(loop.direction == Direction::decreasing ? "-" : "+", wanted["dir"]) << i;
      EXPECT_EQ(print(loop.needle), wanted["made_on"]) << i;
      EXPECT_EQ(locate_loop(loop.span).line, wanted["line"]) << i;
      EXPECT_EQ(loop.kind == LoopKind::tuck, wanted["op"] == "tuck") << i;
      EXPECT_EQ(through, parents) << i;
      EXPECT_EQ(previous[i], wanted["prev"].is_null() ? -1 : wanted["prev"].get<int>()) << i;
    }
  }
}

/// Operations only, one blank between words, `1` for `+1.0`; what is left of a file without its comments.
std::vector<std::string> bare_lines(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::string> bare;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find(';')));
    std::string joined;
    for (std::string word; words >> word;) {
      if (joined == "rack") word = (std::ostringstream() << std::stod(word)).str();
      joined += (joined.empty() ? "" : " ") + word;
    }
    if (!joined.empty()) bare.push_back(joined);
  }
  return bare;
}

TEST(KnitoutCorpus, IsReadAndWrittenWithoutAnyChangeButComments) {
  const auto rows = read_table(read_text(shared_folder / "corpus/manifest.csv"));
  if (rows.empty()) GTEST_SKIP() << "no corpus beside the checkout";
  for (const Row& row : rows) {
    const auto first = knit(shared_folder / "corpus" / row.at("path"));
    const std::string written = print(first->program);
    const auto lines = bare_lines(written), wanted = bare_lines(first->source.text);
    const auto differ = std::mismatch(lines.begin(), lines.end(), wanted.begin(), wanted.end());
    EXPECT_EQ(differ.first == lines.end() ? "" : *differ.first, differ.second == wanted.end() ? "" : *differ.second)
        << row.at("path");
    const Source again{"again.k", written};
    Diagnostics say;
    const Program second = passes::parse_knitout(again, say);
    EXPECT_FALSE(say.failed());
    EXPECT_EQ(print(second), written);
    EXPECT_EQ(second.carriers, first->program.carriers);
    EXPECT_EQ(second.machine, first->program.machine);
  }
}

/// "5(1)", a loop and its carrier, for every loop on each needle, from the hook's base to its tip as recorded.
std::map<std::string, std::vector<std::string>> stacks(const StitchGraph& graph) {
  std::map<std::string, std::vector<std::string>> named;
  for (const HeldLoops& each : graph.on_needles) {
    std::vector<std::string>& names = named[print(each.needle)];
    for (const int loop : each.loops) {
      const int carrier = graph.loops[static_cast<std::size_t>(loop)].carrier;
      names.push_back(std::to_string(loop) + "(" + graph.carriers[static_cast<std::size_t>(carrier)] + ")");
    }
    if (on_back(each.needle)) std::reverse(names.begin(), names.end());
  }
  return named;
}

TEST(KnitoutMicro, LeavesTheRecordedLoopsOnTheNeedles) {
  if (!std::filesystem::exists(shared_folder / "knitout-micro/results.json")) GTEST_SKIP() << "no micro cases";
  for (const auto& recorded : nlohmann::json::parse(read_text(shared_folder / "knitout-micro/results.json"))) {
    const std::string name = recorded["case"];
    SCOPED_TRACE(name);
    const auto knitted = knit(shared_folder / "knitout-micro" / (name + ".k"));
    const StitchGraph& graph = knitted->graph;
    EXPECT_EQ(graph.loops.size(), recorded["loops"]);
    std::vector<std::pair<int, int>> edges, wanted = recorded["edges"];
    for (int child = 0; child < static_cast<int>(graph.loops.size()); ++child)
      for (const int parent : graph.loops[static_cast<std::size_t>(child)].through) edges.emplace_back(parent, child);
    std::sort(edges.begin(), edges.end());
    std::sort(wanted.begin(), wanted.end());
    EXPECT_EQ(edges, wanted);
    const std::map<std::string, std::vector<std::string>> on_needles = recorded["on"];
    EXPECT_EQ(stacks(graph), on_needles);
  }
}

}  // namespace
}  // namespace wale
