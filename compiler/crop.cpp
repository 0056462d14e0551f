#include "compiler/crop.hpp"

#include <charconv>

namespace wale {
namespace {

std::optional<int> whole(std::string_view text) {
  int value = 0;
  const auto [stopped, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc{} || stopped != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<IntRange> parse_range(std::string_view text) {
  if (const auto alone = whole(text)) return IntRange{*alone, *alone};
  const std::size_t dash = text.find('-', 1);
  if (dash == text.npos) return std::nullopt;
  const auto first = whole(text.substr(0, dash)), last = whole(text.substr(dash + 1));
  if (!first || !last || *first > *last) return std::nullopt;
  return IntRange{*first, *last};
}

}  // namespace wale
