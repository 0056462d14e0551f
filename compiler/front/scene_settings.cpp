#include "compiler/front/scene_settings.hpp"

#include <algorithm>

namespace wale {
namespace {

std::string quoted(std::string_view key) { return fmt::format("\"{}\"", key); }

}  // namespace

void Settings::require(std::string_view key, std::string hint) const {
  if (node_.find(key)) return;
  const Span place =
      node_.kind == YamlNode::Kind::null ? node_.span : Span{node_.span.source, node_.span.begin, node_.span.begin};
  say_.error("Y005", place, fmt::format("\"{}\" is missing in {}", key, what_), std::move(hint));
}

void Settings::count(std::string_view key, int least, int most, int& value) const {
  if (const YamlNode* given = node_.find(key))
    value = read_count(*given, quoted(key), least, most, say_).value_or(value);
}

void Settings::quantity(std::string_view key, const Dimension& dimension, Range range, double& value) const {
  if (const YamlNode* given = node_.find(key))
    value = read_quantity(*given, quoted(key), dimension, range, say_).value_or(value);
}

void Settings::flag(std::string_view key, bool& value) const {
  if (const YamlNode* given = node_.find(key)) value = read_bool(*given, quoted(key), say_).value_or(value);
}

void Settings::vector(std::string_view key, std::string_view noun, const Dimension& dimension, Range range,
                      std::string hint, Vec3& value) const {
  const YamlNode* given = node_.find(key);
  if (!given) return;
  if (given->kind != YamlNode::Kind::list || given->items.size() != 3) {
    const std::string count = given->kind == YamlNode::Kind::list ? std::to_string(given->items.size()) : "one";
    say_.error("Y004", given->span, fmt::format("{} has 3 components, but this has {}", noun, count), std::move(hint));
    return;
  }
  for (int axis = 0; axis < 3; ++axis)
    value[axis] = read_quantity(given->items[static_cast<std::size_t>(axis)], noun, dimension, range, say_).value_or(0);
}

void Settings::yarns(std::string_view key, Mentions& mentions, std::vector<int>& value) const {
  const YamlNode* given = node_.find(key);
  if (!given) return;
  const auto add = [&](const YamlNode& item) {
    const auto name = read_text(item, "a yarn's name", say_);
    if (!name) return;
    value.push_back(static_cast<int>(mentions.yarns.size()));
    mentions.yarns.push_back({*name, item.span});
  };
  value.clear();
  if (given->kind != YamlNode::Kind::list) {
    add(*given);
  } else if (given->items.empty()) {
    say_.error("Y004", given->span, fmt::format("{} names no yarn", quoted(key)),
               "write `[main]`, or leave it out for all yarns");
  } else {
    for (const YamlNode& item : given->items) add(item);
  }
}

std::optional<IntRange> read_range(const YamlNode* node, Diagnostics& say) {
  if (!node) return std::nullopt;
  const auto range = parse_range(node->text);
  if (!range)
    say.error("Y007", node->span, fmt::format("\"{}\" is not a range", node->text),
              "write the first and the last, as in 5-20");
  return range;
}

void Settings::part(std::string_view key, Mentions& mentions, Part& value) const {
  const YamlNode* given = node_.find(key);
  if (!given || given->kind != YamlNode::Kind::map) return yarns(key, mentions, value.materials);
  const Settings part(*given, "a part of a fabric", {"yarns", "courses", "wales", "needles"}, say_);
  part.yarns("yarns", mentions, value.materials);
  const Mentions::Region region{read_range(part.find("courses"), say_), read_range(part.find("wales"), say_),
                                read_range(part.find("needles"), say_), given->span};
  if (!region.courses && !region.wales && !region.needles) return;
  value.segments = {static_cast<int>(mentions.regions.size())};
  mentions.regions.push_back(region);
}

}  // namespace wale
