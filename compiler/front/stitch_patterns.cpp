#include "compiler/front/stitch_patterns.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <initializer_list>

namespace wale {
namespace {

constexpr int widest_block = 1000;

StitchTile tile(std::initializer_list<std::string_view> rows) {
  StitchTile result;
  for (const std::string_view row : rows) {
    result.rows.emplace_back();
    for (const char c : row) result.rows.back().push_back(c == 'k' ? Stitch::knit : Stitch::purl);
  }
  return result;
}

/// Two numbers written as "2x1".
struct Block {
  int first = 0, second = 0;
};

std::optional<Block> parse_block(std::string_view text) {
  Block block;
  const char* const last = text.data() + text.size();
  const auto one = std::from_chars(text.data(), last, block.first);
  if (one.ec != std::errc{} || one.ptr == last || *one.ptr != 'x') return std::nullopt;
  const auto two = std::from_chars(one.ptr + 1, last, block.second);
  const bool sensible = std::min(block.first, block.second) >= 1 && std::max(block.first, block.second) <= widest_block;
  if (two.ec != std::errc{} || two.ptr != last || !sensible) return std::nullopt;
  return block;
}

std::vector<Stitch> rib_row(const Block& block) {
  std::vector<Stitch> row(static_cast<std::size_t>(block.first), Stitch::knit);
  row.resize(static_cast<std::size_t>(block.first + block.second), Stitch::purl);
  return row;
}

StitchTile garter(const Block& block) {
  StitchTile result;
  for (const Stitch stitch : rib_row(block)) result.rows.push_back({stitch});
  return result;
}

/// Blocks of `first` wales by `second` courses, knit and purl by turns; the first block is knit.
StitchTile basket(const Block& block) {
  const std::vector<Stitch> even = rib_row({block.first, block.first});
  const std::vector<Stitch> odd(even.rbegin(), even.rend());
  StitchTile result;
  result.rows.assign(static_cast<std::size_t>(block.second), even);
  result.rows.insert(result.rows.end(), static_cast<std::size_t>(block.second), odd);
  return result;
}

std::string normalised(std::string_view name) {
  std::string text(name);
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return text;
}

}  // namespace

std::optional<StitchTile> built_in_stitch(std::string_view written) {
  const std::string name = normalised(written);
  if (name == "jersey" || name == "stockinette") return tile({"k"});
  if (name == "reverse" || name == "purl") return tile({"p"});
  if (name == "garter") return garter({1, 1});
  if (name == "seed") return tile({"pk", "kp"});
  if (name == "moss") return tile({"pk", "pk", "kp", "kp"});
  const std::size_t space = name.find(' ');
  if (space == std::string::npos) return std::nullopt;
  const std::optional<Block> block = parse_block(std::string_view(name).substr(space + 1));
  if (!block) return std::nullopt;
  const std::string_view family = std::string_view(name).substr(0, space);
  if (family == "rib") return StitchTile{{rib_row(*block)}};
  if (family == "garter") return garter(*block);
  if (family == "basket") return basket(*block);
  return std::nullopt;
}

const std::vector<std::string_view>& built_in_stitch_names() {
  static const std::vector<std::string_view> names{"jersey", "stockinette", "reverse",   "purl",
                                                   "garter", "garter 2x2",  "rib 1x1",   "rib 2x2",
                                                   "seed",   "moss",        "basket 3x3"};
  return names;
}

}  // namespace wale
