// Everything that a reader may copy must run: the library, the examples, and the blocks in the documentation.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "compiler/compile.hpp"
#include "compiler/front/scene.hpp"
#include "compiler/passes.hpp"

namespace wale {
namespace {

namespace fs = std::filesystem;

/// The ```yaml blocks of a page that begin with `first_line`.
std::vector<std::string> blocks_in(const std::string& page, const std::string& first_line) {
  std::ifstream stream(WALE_SOURCE_DIR "/docs/" + page);
  std::vector<std::string> blocks;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      inside = line == "```yaml";
      if (inside) blocks.emplace_back();
    } else if (inside) {
      blocks.back() += line + "\n";
    }
  }
  std::erase_if(blocks, [&](const std::string& block) { return !block.starts_with(first_line); });
  return blocks;
}

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(WALE_SOURCE_DIR "/" + folder)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  }
  return files;
}

void expect_silence(const Diagnostics& say, const std::string& where) {
  for (const Diagnostic& one : say.all()) ADD_FAILURE() << print(one) << where;
}

TEST(Documentation, EveryChartInItIsRead) {
  const auto blocks = blocks_in("charts.md", "knit: 1\n");
  EXPECT_GE(blocks.size(), 14u);
  for (const std::string& block : blocks) {
    Sources sources;
    Diagnostics say;
    EXPECT_TRUE(passes::parse_chart(*sources.add("charts.md", block), {}, say)) << block;
    expect_silence(say, block);
  }
}

TEST(Documentation, EverySceneInItIsRead) {
  const auto blocks = blocks_in("scenes.md", "scene: 1\n");
  EXPECT_GE(blocks.size(), 2u);
  for (const std::string& block : blocks) {
    Sources sources;
    Diagnostics say;
    const Source* source = sources.add(WALE_SOURCE_DIR "/docs/scenes.md", block);
    EXPECT_TRUE(parse_scene(*source, say)) << block;
    expect_silence(say, block);
    EXPECT_TRUE(compile_scene(*source, sources, say)) << block;
  }
}

TEST(Library, EveryPatternIsReadWithoutAWarning) {
  const auto files = files_in("patterns");
  EXPECT_GE(files.size(), 15u);
  for (const std::string& file : files) {
    Sources sources;
    Diagnostics say;
    const Source* source = sources.read(file);
    ASSERT_NE(source, nullptr);
    EXPECT_TRUE(source->text.starts_with("# ")) << file << " should say what it is";
    EXPECT_TRUE(passes::parse_chart(*source, {}, say)) << file;
    expect_silence(say, file);
  }
}

TEST(Examples, EverySceneIsReadWithItsChart) {
  const auto files = files_in("examples");
  EXPECT_GE(files.size(), 14u);
  for (const std::string& file : files) {
    Sources sources;
    Diagnostics say;
    const Source* source = sources.read(file);
    ASSERT_NE(source, nullptr);
    const auto scene = parse_scene(*source, say);
    ASSERT_TRUE(scene) << file;
    const Source* chart = read_pattern(*scene, sources, say);
    ASSERT_NE(chart, nullptr) << file;
    if (chart->name.ends_with(".k")) {
      passes::parse_knitout(*chart, say);
    } else {
      EXPECT_TRUE(passes::parse_chart(*chart, scene->overrides, say)) << file;
    }
    expect_silence(say, file);
    EXPECT_TRUE(fs::exists(fs::path(file).parent_path() / "README.md")) << file;
  }
}

}  // namespace
}  // namespace wale
