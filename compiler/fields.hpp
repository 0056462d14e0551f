/// Reads maps with known keys and scalars with known meaning from YAML, and says what is wrong with them.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/spelling.hpp"
#include "compiler/units.hpp"
#include "compiler/yaml.hpp"

namespace wale {

/// A map of which every key is known: reports the others once, when it is made. `node` must outlive it.
class Fields {
 public:
  /// `what` names the map in messages: "a band".
  Fields(const YamlNode& node, std::string_view what, std::vector<std::string_view> known, Diagnostics&);
  /// Null if absent, or if the node is no map.
  const YamlNode* find(std::string_view key) const { return node_.find(key); }
  /// Reports an absent key, unless it was misspelt; `hint` shows how to give it.
  const YamlNode* require(std::string_view key, std::string hint) const;
  bool is_map() const { return node_.kind == YamlNode::Kind::map; }

 private:
  const YamlNode& node_;
  std::string_view what_;
  std::vector<std::string_view> meant_;  // known keys that were misspelt
  Diagnostics& say_;
};

/// Limits that a sensible value keeps, both allowed, SI.
struct Range {
  double least = 0, most = 0;
};

std::optional<std::string> read_text(const YamlNode&, std::string_view what, Diagnostics&);
std::optional<int> read_count(const YamlNode&, std::string_view what, int least, int most, Diagnostics&);
std::optional<double> read_quantity(const YamlNode&, std::string_view what, const Dimension&, Range, Diagnostics&);
/// The same from a text that is no value of its own.
std::optional<double> read_quantity(std::string_view text, Span, std::string_view what, const Dimension&, Range,
                                    Diagnostics&);
/// The place of the scalar in `words`; reports any other word, with those allowed.
std::optional<std::size_t> read_word(const YamlNode&, std::string_view what, const std::vector<std::string_view>& words,
                                     Diagnostics&);
std::optional<bool> read_bool(const YamlNode&, std::string_view what, Diagnostics&);

}  // namespace wale
