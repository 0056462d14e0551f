#include "studio/cli/knitout_options.hpp"

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
