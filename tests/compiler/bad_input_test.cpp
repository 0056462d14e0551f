#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "compiler/codes.hpp"
#include "compiler/compile.hpp"

namespace wale {
namespace {

const std::string folder = WALE_SOURCE_DIR "/tests/golden/errors/";

std::vector<std::string> golden_files() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().filename().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> expected_in(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("#= ")) lines.push_back(line.substr(3));
  }
  return lines;
}

/// Reads a golden file as the command line would.
void read(const Source& source, Sources& sources, Diagnostics& say) {
  if (source.name.find(".scene.") == std::string::npos)
    passes::parse_chart(source, {}, say);
  else
    compile_scene(source, sources, say);
}

/// The first line of a printed diagnostic, without the folder.
std::string first_line(const Diagnostic& diagnostic) {
  std::string line = print(diagnostic);
  line.resize(line.find('\n'));
  for (std::size_t at = line.find(folder); at != std::string::npos; at = line.find(folder))
    line.erase(at, folder.size());
  return line;
}

class BadInput : public testing::TestWithParam<std::string> {};

TEST_P(BadInput, IsReportedWhereItStands) {
  Sources sources;
  const Source* source = sources.read(folder + GetParam());
  ASSERT_NE(source, nullptr);
  Diagnostics say;
  read(*source, sources, say);
  std::vector<std::string> found;
  for (const Diagnostic& one : say.all()) found.push_back(first_line(one));
  EXPECT_EQ(found, expected_in(source->text));
}

TEST_P(BadInput, IsReportedWithAHintAndACodeOfTheTable) {
  Sources sources;
  const Source* source = sources.read(folder + GetParam());
  ASSERT_NE(source, nullptr);
  Diagnostics say;
  read(*source, sources, say);
  EXPECT_FALSE(say.all().empty());
  for (const Diagnostic& one : say.all()) {
    EXPECT_FALSE(one.hint.empty()) << print(one);
    const CodeInfo* info = find_code(one.code);
    ASSERT_NE(info, nullptr) << one.code;
    EXPECT_EQ(info->severity, one.severity) << one.code;
  }
}

INSTANTIATE_TEST_SUITE_P(Golden, BadInput, testing::ValuesIn(golden_files()), [](const auto& file) {
  std::string name = file.param.substr(0, file.param.size() - 5);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

TEST(Codes, AreDifferentAndInOrder) {
  std::set<std::string_view> seen;
  for (const CodeInfo& info : code_table) {
    EXPECT_TRUE(seen.insert(info.code).second) << info.code;
    EXPECT_FALSE(info.meaning.empty()) << info.code;
    EXPECT_FALSE(info.fix.empty()) << info.code;
  }
}

TEST(Codes, OfTheFrontAreEachShownByAGoldenFile) {
  std::string all;
  for (const std::string& file : golden_files()) {
    std::ifstream stream(folder + file);
    all += std::string{std::istreambuf_iterator<char>(stream), {}};
  }
  for (const CodeInfo& info : front_codes) {
    EXPECT_NE(all.find("[" + std::string(info.code) + "]"), std::string::npos) << info.code;
  }
}

/// What the source says between quotes as a code: a capital letter and three digits.
std::set<std::string> codes_written_in(const std::filesystem::path& file) {
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::set<std::string> codes;
  for (std::size_t i = 0; i + 6 <= text.size(); ++i) {
    const auto digit = [&](std::size_t at) { return std::isdigit(static_cast<unsigned char>(text[at])) != 0; };
    const bool letter = std::isupper(static_cast<unsigned char>(text[i + 1])) != 0;
    if (text[i] == '"' && letter && digit(i + 2) && digit(i + 3) && digit(i + 4) && text[i + 5] == '"') {
      codes.insert(text.substr(i + 1, 4));
    }
  }
  return codes;
}

TEST(Codes, ThatTheCompilerWritesAreAllInTheTable) {
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(WALE_SOURCE_DIR "/compiler")) {
    if (entry.path().extension() != ".cpp") continue;
    for (const std::string& code : codes_written_in(entry.path())) {
      EXPECT_NE(find_code(code), nullptr) << code << " in " << entry.path();
      ++found;
    }
  }
  EXPECT_GT(found, front_codes.size() / 2);
}

}  // namespace
}  // namespace wale
