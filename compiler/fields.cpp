#include "compiler/fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

namespace wale {
namespace {

std::string_view name_of(YamlNode::Kind kind) {
  switch (kind) {
    case YamlNode::Kind::null:
      return "nothing";
    case YamlNode::Kind::scalar:
      return "a single value";
    case YamlNode::Kind::list:
      return "a list";
    case YamlNode::Kind::map:
      return "a map";
  }
  return {};
}

bool is_scalar(const YamlNode& node, std::string_view what, Diagnostics& say) {
  if (node.kind == YamlNode::Kind::scalar) return true;
  say.error("Y004", node.span, fmt::format("{} must be a single value, but this is {}", what, name_of(node.kind)),
            "write one word or one quantity behind the colon");
  return false;
}

}  // namespace

Fields::Fields(const YamlNode& node, std::string_view what, std::vector<std::string_view> known, Diagnostics& say)
    : node_(node), what_(what), say_(say) {
  if (node.kind != YamlNode::Kind::map) {
    say.error("Y004", node.span, fmt::format("{} must be a map, but this is {}", what, name_of(node.kind)),
              fmt::format("write `key: value`; known keys are {}", fmt::join(known, ", ")));
    return;
  }
  for (const YamlEntry& entry : node.entries) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    meant_.push_back(nearest(entry.key, known));
    say.error("Y003", entry.span, fmt::format("unknown key \"{}\" in {}", entry.key, what), suggest(entry.key, known));
  }
}

const YamlNode* Fields::require(std::string_view key, std::string hint) const {
  const YamlNode* found = find(key);
  const bool misspelt = std::find(meant_.begin(), meant_.end(), key) != meant_.end();
  if (!found && is_map() && !misspelt) {
    const Span place{node_.span.source, node_.span.begin, node_.span.begin};
    say_.error("Y005", place, fmt::format("\"{}\" is missing in {}", key, what_), std::move(hint));
  }
  return found;
}

std::optional<std::string> read_text(const YamlNode& node, std::string_view what, Diagnostics& say) {
  if (!is_scalar(node, what, say)) return std::nullopt;
  return node.text;
}

std::optional<int> read_count(const YamlNode& node, std::string_view what, int least, int most, Diagnostics& say) {
  if (!is_scalar(node, what, say)) return std::nullopt;
  int number = 0;
  const char* const last = node.text.data() + node.text.size();
  const auto [end, problem] = std::from_chars(node.text.data(), last, number);
  const std::string hint = fmt::format("write a whole number from {} to {}", least, most);
  if (problem == std::errc::result_out_of_range) {
    say.error("Y007", node.span, fmt::format("{} cannot be {}", what, node.text), hint);
  } else if (problem != std::errc{} || end != last) {
    say.error("Y007", node.span, fmt::format("{} must be a whole number, but this is \"{}\"", what, node.text), hint);
  } else if (number < least || number > most) {
    say.error("Y007", node.span, fmt::format("{} cannot be {}", what, number), hint);
  } else {
    return number;
  }
  return std::nullopt;
}

std::optional<double> read_quantity(const YamlNode& node, std::string_view what, const Dimension& dimension,
                                    Range range, Diagnostics& say) {
  if (!is_scalar(node, what, say)) return std::nullopt;
  return read_quantity(node.text, node.span, what, dimension, range, say);
}

std::optional<double> read_quantity(std::string_view text, Span span, std::string_view what, const Dimension& dimension,
                                    Range range, Diagnostics& say) {
  const std::optional<double> value = parse_quantity(text, dimension, span, say);
  if (!value || (*value >= range.least && *value <= range.most)) return value;
  const std::string unit = dimension.unit == "1" ? "" : fmt::format(" {}", dimension.unit);
  say.error("U005", span, fmt::format("{} cannot be {}", what, text),
            fmt::format("write {} from {:g}{} to {:g}{}, as in `{}`", dimension.noun, range.least, unit, range.most,
                        unit, dimension.example));
  return std::nullopt;
}

std::optional<std::size_t> read_word(const YamlNode& node, std::string_view what,
                                     const std::vector<std::string_view>& words, Diagnostics& say) {
  if (!is_scalar(node, what, say)) return std::nullopt;
  const auto found = std::find(words.begin(), words.end(), node.text);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  say.error("Y008", node.span, fmt::format("{} cannot be \"{}\"", what, node.text), suggest(node.text, words));
  return std::nullopt;
}

std::optional<bool> read_bool(const YamlNode& node, std::string_view what, Diagnostics& say) {
  const auto word = read_word(node, what, {"false", "true"}, say);
  if (!word) return std::nullopt;
  return *word == 1;
}

}  // namespace wale
