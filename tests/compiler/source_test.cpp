#include "compiler/source.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "compiler/diagnostic.hpp"
#include "compiler/spelling.hpp"

namespace wale {
namespace {

TEST(Source, LinesAndColumnsCountFromOne) {
  const Source source{"a.yaml", "one\ntwo\n\nfour"};
  const auto at = [&](std::uint32_t begin) { return locate({&source, begin, begin + 1}); };
  EXPECT_EQ(at(0).line, 1);
  EXPECT_EQ(at(0).column, 1);
  EXPECT_EQ(at(3).line, 1);  // the line break belongs to its line
  EXPECT_EQ(at(3).column, 4);
  EXPECT_EQ(at(4).line, 2);
  EXPECT_EQ(at(4).column, 1);
  EXPECT_EQ(at(12).line, 4);
  EXPECT_EQ(at(12).column, 4);
  EXPECT_EQ(at(999).line, 4);
}

TEST(Source, IsLocatedAlikeOnceAndManyTimes) {
  const Source source{"a.yaml", "one\ntwo\n\nfour"};
  Locator locator;
  for (std::uint32_t at = 0; at < source.text.size(); ++at) {
    EXPECT_EQ(locator({&source, at, at}).line, locate({&source, at, at}).line) << at;
    EXPECT_EQ(locator({&source, at, at}).column, locate({&source, at, at}).column) << at;
  }
  EXPECT_EQ(locator({}).line, 0);
}

TEST(Source, IsNotReadFromDiskIfItIsKnown) {
  Sources sources;
  const Source* added = sources.add("no/such/file.yaml", "knit: 1");
  EXPECT_EQ(sources.read("no/such/file.yaml"), added);
  EXPECT_EQ(sources.read("no/such/other.yaml"), nullptr);
  EXPECT_EQ(sources.read(WALE_SOURCE_DIR), nullptr);  // a folder
}

TEST(Source, IsReadFromDiskOnce) {
  const std::string path = (std::filesystem::path(testing::TempDir()) / "wale_source_test.yaml").string();
  std::ofstream(path, std::ios::binary) << "knit: 1\r\n";
  Sources sources;
  const Source* first = sources.read(path);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->text, "knit: 1\r\n");
  for (int i = 0; i < 100; ++i) sources.add(std::to_string(i), "");
  EXPECT_EQ(sources.read(path), first);  // and stays where it is
  std::filesystem::remove(path);
}

TEST(Diagnostic, PrintsPlaceMessageCodeLineCaretsAndHint) {
  const Source source{"a.yaml", "knit: 1\nwalse: 12\n"};
  const Diagnostic one{Severity::error, "Y003", {&source, 8, 13}, "unknown key \"walse\"", "did you mean \"wales\"?"};
  EXPECT_EQ(print(one),
            "a.yaml:2:1: error: unknown key \"walse\" [Y003]\n"
            "    walse: 12\n"
            "    ^^^^^\n"
            "  hint: did you mean \"wales\"?\n");
}

TEST(Diagnostic, PutsCaretsUnderCharactersNotBytes) {
  const Source source{"a.yaml", "größe: x\n"};
  const std::string text = print(Diagnostic{Severity::warning, "Y003", {&source, 9, 10}, "m", {}});
  EXPECT_EQ(text, "a.yaml:1:10: warning: m [Y003]\n    größe: x\n           ^\n");
}

TEST(Diagnostic, CutsALongLineAroundTheCarets) {
  Source source{"a.yaml", std::string(5000, 'k')};
  source.text[4000] = 'q';
  const std::string text = print(Diagnostic{Severity::error, "C003", {&source, 4000, 4001}, "m", {}});
  EXPECT_LT(text.size(), 400u);
  const std::size_t line = text.find('\n') + 1;
  const std::size_t carets = text.find('\n', line) + 1;
  EXPECT_EQ(text.find('q') - line, text.find('^') - carets);
}

TEST(Diagnostic, OfASpanOverSeveralLinesMarksTheFirst) {
  const Source source{"a.yaml", "ab\ncd\n"};
  EXPECT_EQ(print(Diagnostic{Severity::error, "C003", {&source, 1, 5}, "m", {}}),
            "a.yaml:1:2: error: m [C003]\n    ab\n     ^\n");
  EXPECT_EQ(print(Diagnostic{Severity::error, "C003", {&source, 6, 6}, "m", {}}),
            "a.yaml:3:1: error: m [C003]\n    \n    ^\n");
  EXPECT_EQ(print(Diagnostic{Severity::error, "C003", {}, "m", {}}), "error: m [C003]\n");
}

TEST(Diagnostics, FailOnlyOnErrors) {
  Diagnostics say;
  say.warning("C020", {}, "tight");
  EXPECT_FALSE(say.failed());
  say.error("C001", {}, "no chart");
  EXPECT_TRUE(say.failed());
  EXPECT_EQ(say.error_count(), 1u);
}

TEST(Spelling, CountsInsertionsDeletionsChangesAndSwaps) {
  EXPECT_EQ(edit_distance("wales", "wales"), 0);
  EXPECT_EQ(edit_distance("walse", "wales"), 1);
  EXPECT_EQ(edit_distance("wale", "wales"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(Spelling, OffersNothingThatIsFarAway) {
  EXPECT_EQ(nearest("yran", {"yarn", "courses"}), "yarn");
  EXPECT_EQ(nearest("wool", {"yarn", "courses"}), "");
  EXPECT_EQ(nearest("q", {"k", "p"}), "");
}

}  // namespace
}  // namespace wale
