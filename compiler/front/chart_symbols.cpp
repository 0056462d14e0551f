#include <fmt/format.h>

#include <cctype>

#include "compiler/fields.hpp"
#include "compiler/front/chart_parts.hpp"
#include "compiler/front/stitch_patterns.hpp"

namespace wale {
namespace {

bool is_symbol(const std::string& text) {
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isspace(byte) || std::isdigit(byte) || std::iscntrl(byte) || c == '#') return false;
  }
  return !text.empty();
}

/// Crossings are maps, all other meanings words.
std::optional<SymbolMeaning> read_meaning(const YamlNode& node, Diagnostics& say) {
  if (node.kind == YamlNode::Kind::map && (node.find("cross") || node.find("tuck") || node.find("miss"))) {
    return SymbolMeaning::unsupported;
  }
  const auto word = read_word(node, "the meaning of a symbol", {"knit", "purl", "tuck", "miss"}, say);
  if (!word) return std::nullopt;
  if (*word == 0) return SymbolMeaning::knit;
  return *word == 1 ? SymbolMeaning::purl : SymbolMeaning::unsupported;
}

}  // namespace

Legend read_legend(const YamlNode& root, Diagnostics& say) {
  Legend legend{{"k", SymbolMeaning::knit}, {"p", SymbolMeaning::purl}};
  const YamlNode* node = root.find("symbols");
  if (!node) return legend;
  if (node->kind != YamlNode::Kind::map) {
    say.error("Y004", node->span, "\"symbols\" must be a map from symbols to stitches",
              "write `symbols: {\".\": knit, \"-\": purl}`");
    return legend;
  }
  for (const YamlEntry& entry : node->entries) {
    // A faulty entry is kept as unsupported, so that its use is not reported as unknown on top.
    const SymbolMeaning meaning = read_meaning(entry.value, say).value_or(SymbolMeaning::unsupported);
    const auto known = legend.find(entry.key);
    if (!is_symbol(entry.key)) {
      say.error("C010", entry.span, fmt::format("\"{}\" cannot be a symbol", entry.key),
                "use characters other than blanks, digits and #");
    } else if (known != legend.end() && known->second != meaning) {
      say.error("C010", entry.span, fmt::format("the symbol \"{}\" already has a meaning", entry.key),
                "k is always knit and p is always purl; use another character");
    } else {
      legend[entry.key] = meaning;
    }
  }
  return legend;
}

Patterns read_patterns(const YamlNode& root, const Legend& legend, Diagnostics& say) {
  Patterns patterns;
  const YamlNode* node = root.find("patterns");
  if (!node) return patterns;
  if (node->kind != YamlNode::Kind::map) {
    say.error("Y004", node->span, "\"patterns\" must be a map from names to pictures",
              "write a name, a colon and `|`, and one row a line below it");
    return patterns;
  }
  std::vector<std::string> symbols;
  for (const auto& [symbol, meaning] : legend) symbols.push_back(symbol);
  for (const YamlEntry& entry : node->entries) {
    if (built_in_stitch(entry.key)) {
      say.error("C010", entry.span, fmt::format("\"{}\" is already a structure", entry.key),
                "give the pattern another name");
    }
    patterns[entry.key] = read_picture(entry.value, "stitch", symbols, say);
  }
  return patterns;
}

}  // namespace wale
