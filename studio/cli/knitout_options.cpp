#include "studio/cli/knitout_options.hpp"

#include <charconv>
#include <string_view>

#include "studio/cli/complain.hpp"
#include "studio/cli/report.hpp"

namespace wale {
namespace {

std::optional<int> whole(std::string_view text) {
  int value = 0;
  const auto [stopped, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc{} || stopped != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "5-20" or "-3--1"; "7" is a range of one.
std::optional<IntRange> range_in(std::string_view text) {
  if (const auto alone = whole(text)) return IntRange{*alone, *alone};
  const std::size_t dash = text.find('-', 1);
  if (dash == text.npos) return std::nullopt;
  const auto first = whole(text.substr(0, dash)), last = whole(text.substr(dash + 1));
  if (!first || !last || *first > *last) return std::nullopt;
  return IntRange{*first, *last};
}

bool read_range(const char* option, const std::string& text, std::optional<IntRange>& range) {
  if (text.empty()) return true;
  range = range_in(text);
  if (!range) complain(option, "\"" + text + "\" is not a range", "write the first and the last, as in 5-20");
  return range.has_value();
}

}  // namespace

std::optional<KnitoutOptions> read_knitout_options(const KnitoutWords& words, Sources& sources) {
  KnitoutOptions options;
  if (!read_range("--courses", words.courses, options.crop.courses)) return std::nullopt;
  if (!read_range("--needles", words.needles, options.crop.needles)) return std::nullopt;
  if (words.stitch_length.empty()) return options;
  const Source* text = sources.add("--stitch-length", words.stitch_length);
  const Span span{text, 0, static_cast<std::uint32_t>(text->text.size())};
  Diagnostics say;
  const auto lengths = parse_stitch_lengths(text->text, span, say);
  print_all(say);
  if (!lengths) return std::nullopt;
  options.stitch_lengths = *lengths;
  return options;
}

}  // namespace wale
