#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace wale {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::vector<std::string>>;  // path from the root -> its lines
using Arrows = std::map<std::string, std::set<std::string>>;    // path -> what it includes of ours
using Found = std::vector<std::string>;

/// Who may not reach whom; both are beginnings of paths.
struct Rule {
  std::string from;
  std::vector<std::string> never;
};

const std::vector<Rule> rules{
    {"sim/", {"compiler/", "studio/"}},
    {"sim/effects/", {"sim/world.hpp", "sim/solver.hpp", "sim/solvers/", "sim/run.hpp", "sim/results/"}},
    {"sim/solvers/", {"sim/effects/"}},
    {"compiler/", {"studio/", "sim/world.hpp", "sim/solver.hpp", "sim/solvers/", "sim/run.hpp", "sim/results/"}}};

bool starts_with(const std::string& text, const std::string& beginning) { return text.rfind(beginning, 0) == 0; }

Files read_tree(const std::vector<std::string>& folders) {
  Files files;
  for (const std::string& folder : folders) {
    const fs::path root = WALE_SOURCE_DIR;
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string suffix = entry.path().extension().string();
      if (suffix != ".hpp" && suffix != ".cpp") continue;
      std::ifstream file(entry.path());
      auto& lines = files[fs::relative(entry.path(), root).generic_string()];
      for (std::string line; std::getline(file, line);) lines.push_back(line);
    }
  }
  return files;
}

Arrows arrows_of(const Files& files) {
  Arrows arrows;
  for (const auto& [path, lines] : files)
    for (const std::string& line : lines) {
      const std::size_t open = line.find('"');
      if (!starts_with(line, "#include") || open == std::string::npos) continue;
      arrows[path].insert(line.substr(open + 1, line.find('"', open + 1) - open - 1));
    }
  return arrows;
}

/// All that a file includes, and what this includes in turn.
std::set<std::string> reach(const Arrows& arrows, const std::string& from) {
  std::set<std::string> reached;
  std::vector<std::string> left{from};
  while (!left.empty()) {
    const auto at = arrows.find(left.back());
    left.pop_back();
    if (at == arrows.end()) continue;
    for (const std::string& to : at->second)
      if (reached.insert(to).second) left.push_back(to);
  }
  return reached;
}

std::vector<std::string> wrong_arrows(const Arrows& arrows) {
  std::vector<std::string> wrong;
  for (const auto& [from, unused] : arrows)
    for (const Rule& rule : rules) {
      if (!starts_with(from, rule.from)) continue;
      for (const std::string& to : reach(arrows, from))
        if (std::any_of(rule.never.begin(), rule.never.end(), [&](const auto& no) { return starts_with(to, no); }))
          wrong.push_back(from + " -> " + to);
    }
  return wrong;
}

TEST(Includes, PointOnlyTheWayTheArchitectureAllows) {
  const Arrows arrows = arrows_of(read_tree({"sim", "compiler", "studio"}));
  ASSERT_TRUE(arrows.contains("sim/effect.hpp") && arrows.contains("compiler/passes.hpp"));
  EXPECT_EQ(wrong_arrows(arrows), Found({}));
}

TEST(Includes, AreFoundWhenTheyPointTheWrongWay) {
  EXPECT_EQ(wrong_arrows({{"sim/run.cpp", {"compiler/chart.hpp"}}}), Found({"sim/run.cpp -> compiler/chart.hpp"}));
  EXPECT_EQ(wrong_arrows({{"sim/effects/a.cpp", {"sim/world.hpp"}}}), Found({"sim/effects/a.cpp -> sim/world.hpp"}));
  EXPECT_EQ(wrong_arrows({{"sim/solvers/a.cpp", {"sim/effects/bend.hpp"}}}),
            Found({"sim/solvers/a.cpp -> sim/effects/bend.hpp"}));
  EXPECT_EQ(wrong_arrows({{"compiler/a.cpp", {"studio/b.hpp"}}}), Found({"compiler/a.cpp -> studio/b.hpp"}));
  EXPECT_EQ(wrong_arrows({{"sim/solvers/a.cpp", {"sim/world.hpp", "sim/effect.hpp"}}}), Found({}));
}

TEST(Includes, AreFoundThroughOtherHeaders) {
  const Arrows arrows{{"compiler/a.cpp", {"sim/scene.hpp"}}, {"sim/scene.hpp", {"sim/run.hpp"}}};
  EXPECT_EQ(wrong_arrows(arrows), Found({"compiler/a.cpp -> sim/run.hpp"}));
}

TEST(Includes, NameThePathOnDisk) {
  for (const auto& [from, targets] : arrows_of(read_tree({"sim", "compiler", "studio", "tests", "bench"})))
    for (const std::string& to : targets)
      EXPECT_TRUE(fs::exists(fs::path(WALE_SOURCE_DIR) / to)) << from << " includes " << to;
}

TEST(Headers, SayFirstWhatTheyAreFor) {
  for (const auto& [path, lines] : read_tree({"sim", "compiler", "studio", "tests", "bench"}))
    if (path.ends_with(".hpp")) {
      EXPECT_TRUE(!lines.empty() && starts_with(lines[0], "/// ")) << path;
    }
}

TEST(Headers, AreIncludedOnce) {
  for (const auto& [path, lines] : read_tree({"sim", "compiler", "studio", "tests", "bench"}))
    if (path.ends_with(".hpp")) {
      EXPECT_EQ(std::count(lines.begin(), lines.end(), "#pragma once"), 1) << path;
    }
}

}  // namespace
}  // namespace wale
