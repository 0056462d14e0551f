#include "compiler/yaml.hpp"

#include <gtest/gtest.h>

#include "compiler/fields.hpp"

namespace wale {
namespace {

/// The text of a span.
std::string text_of(const Span& span) { return span.source->text.substr(span.begin, span.end - span.begin); }

YamlNode parse(const Source& source) {
  Diagnostics say;
  auto root = parse_yaml(source, say);
  EXPECT_TRUE(root && !say.failed()) << (say.all().empty() ? "" : print(say.all()[0]));
  return root.value_or(YamlNode{});
}

TEST(Yaml, EveryScalarKnowsItsPlace) {
  const Source source{"a.yaml", "a: plain\nb: \"quo\\\"ted\" # c\nc: 'it''s'\nd: [one, two]\ne: {f: 7.23 mm}\n"};
  const YamlNode root = parse(source);
  EXPECT_EQ(text_of(root.find("a")->span), "plain");
  EXPECT_EQ(text_of(root.find("b")->span), "\"quo\\\"ted\"");
  EXPECT_EQ(text_of(root.find("c")->span), "'it''s'");
  EXPECT_EQ(root.find("c")->text, "it's");
  EXPECT_EQ(text_of(root.find("d")->items[1].span), "two");
  EXPECT_EQ(text_of(root.find("d")->span), "[one, two]");
  EXPECT_EQ(text_of(root.find("e")->find("f")->span), "7.23 mm");
  EXPECT_EQ(text_of(root.find("e")->span), "{f: 7.23 mm}");
  EXPECT_EQ(text_of(root.entries[4].span), "e");
}

TEST(Yaml, ABlockEndsWhereItsIndentationEnds) {
  const Source source{"a.yaml", "a:\n  b: |\n    kk\n\n    pp\n  c: 1\nd: |\n  x\n"};
  const YamlNode root = parse(source);
  EXPECT_EQ(text_of(root.find("a")->find("b")->span), "|\n    kk\n\n    pp");
  EXPECT_EQ(root.find("a")->find("b")->style, YamlNode::Style::literal);
  EXPECT_EQ(text_of(root.find("d")->span), "|\n  x");
}

TEST(Yaml, ABlockInAListItemEndsBeforeTheNextKey) {
  const Source source{"a.yaml", "- stitch: |\n    kk\n  courses: 3\n- |\n  pp\n- x\n"};
  const YamlNode root = parse(source);
  EXPECT_EQ(text_of(root.items[0].find("stitch")->span), "|\n    kk");
  EXPECT_EQ(text_of(root.items[1].span), "|\n  pp");
}

TEST(Yaml, PlacesAreRightAfterAByteOrderMarkWideCharactersAndCarriageReturns) {
  const Source source{"a.yaml", "\xEF\xBB\xBFname: größe\r\nb: here\r\n"};
  const YamlNode root = parse(source);
  EXPECT_EQ(text_of(root.find("name")->span), "größe");
  EXPECT_EQ(text_of(root.find("b")->span), "here");
}

TEST(Yaml, WordsAreNotTakenForTruthOrTime) {
  const Source source{"a.yaml", "a: no\nb: 1:2\nc: ~\nd:\n"};
  const YamlNode root = parse(source);
  EXPECT_EQ(root.find("a")->text, "no");
  EXPECT_EQ(root.find("b")->text, "1:2");
  EXPECT_EQ(root.find("d")->kind, YamlNode::Kind::null);
  EXPECT_EQ(text_of(root.find("d")->span), "d");
}

TEST(Yaml, AliasesCannotGrowWithoutEnd) {
  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 10; ++i) {
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int j = 0; j < 8; ++j) text += (j ? ", *a" : "*a") + std::to_string(i - 1);
    text += "]\n";
  }
  const Source source{"a.yaml", text};
  Diagnostics say;
  EXPECT_FALSE(parse_yaml(source, say));
  ASSERT_FALSE(say.all().empty());
  EXPECT_EQ(say.all().back().code, "Y001");
}

TEST(Yaml, NoTextMakesItThrow) {
  const std::string good =
      "knit: 1\nyarns: {a: {color: \"#ffffff\"}}\nbands:\n  - stitch: |\n      kp\n    courses: [1, '2']\n";
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const char c : std::string("{}[]\"'|>&*!%@`:#\t\n\x01\xff")) {
      Source source{"a.yaml", good};
      source.text[i] = c;
      Diagnostics say;
      EXPECT_NO_THROW(parse_yaml(source, say)) << source.text;
      for (const Diagnostic& one : say.all()) EXPECT_NO_THROW(print(one));
    }
    Diagnostics say;
    const Source cut{"a.yaml", good.substr(0, i)};
    EXPECT_NO_THROW(parse_yaml(cut, say)) << cut.text;
  }
}

TEST(Fields, DoNotAskForAKeyThatWasMisspelt) {
  const Source source{"a.yaml", "walse: 12\n"};
  const YamlNode root = parse(source);
  Diagnostics say;
  const Fields fields(root, "a chart", {"wales", "courses"}, say);
  EXPECT_EQ(fields.require("wales", "add it"), nullptr);
  EXPECT_EQ(say.all().size(), 1u);
  EXPECT_EQ(fields.require("courses", "add it"), nullptr);
  EXPECT_EQ(say.all().size(), 2u);
}

}  // namespace
}  // namespace wale
