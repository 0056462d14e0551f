/// YAML as a tree of plain values, each of which knows its place in the text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/diagnostic.hpp"

namespace wale {

struct YamlEntry;

/// Scalars are kept as text: what they mean is the reader's business, so `no` and `1:2` hold no surprises.
struct YamlNode {
  enum class Kind : std::uint8_t { null, scalar, list, map };
  enum class Style : std::uint8_t { plain, quoted, literal, folded };  ///< literal is `|`, folded is `>`

  Kind kind = Kind::null;
  Style style = Style::plain;
  Span span;                       ///< of a null: the key that has no value
  std::string text;                ///< of a scalar
  std::vector<YamlNode> items;     ///< of a list
  std::vector<YamlEntry> entries;  ///< of a map, in the order written

  const YamlNode* find(std::string_view key) const;  ///< null if this is no map or has no such key
};

struct YamlEntry {
  std::string key;
  Span span;  ///< of the key
  YamlNode value;
};

/// The one document of a text. Reports syntax errors, tabs, keys given twice (the first one stands).
std::optional<YamlNode> parse_yaml(const Source&, Diagnostics&);

}  // namespace wale
