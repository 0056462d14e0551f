#include "studio/cli/knitout_options.hpp"

#include <algorithm>

#include "studio/cli/complain.hpp"
#include "studio/cli/report.hpp"

namespace wale {
namespace {

bool read_range(const char* option, const std::string& text, std::optional<IntRange>& range) {
  if (text.empty()) return true;
  range = parse_range(text);
  if (!range) complain(option, "\"" + text + "\" is not a range", "write the first and the last, as in 5-20");
  return range.has_value();
}

bool read_plating(const std::string& word, Plating& plating) {
  if (word.empty()) return true;
  const auto found = std::find(plating_words.begin(), plating_words.end(), word);
  if (found == plating_words.end()) {
    complain("--plating", "\"" + word + "\" is no way to plate", "write first_in_front or first_behind");
    return false;
  }
  plating = Plating{static_cast<std::uint8_t>(found - plating_words.begin())};
  return true;
}

}  // namespace

void add_plating(CLI::App& command, KnitoutWords& words) {
  command.add_option("--plating", words.plating,
                     "Of a knitout file, where the first-named of several carriers lies: first_in_front or "
                     "first_behind");
}

std::optional<KnitoutOptions> read_knitout_options(const KnitoutWords& words, Sources& sources) {
  KnitoutOptions options;
  if (!read_range("--courses", words.courses, options.crop.courses)) return std::nullopt;
  if (!read_range("--needles", words.needles, options.crop.needles)) return std::nullopt;
  if (!read_plating(words.plating, options.plating)) return std::nullopt;
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
