#include "compiler/stitch_lengths.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/fields.hpp"
#include "compiler/front/knitout_parts.hpp"
#include "compiler/front/limits.hpp"
#include "compiler/machines.hpp"

namespace wale {
namespace {

constexpr double metres_per_inch = 0.0254;
constexpr double pitches_per_loop = 3;
constexpr double kniterate_step = 0.06;  // of the middle length, by number
constexpr int kniterate_middle = 5;
constexpr std::string_view kniterate_numbers = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";

/// The place of `part` of `text`, which is found in `span` unless it was written with escapes; quotes do not matter.
Span place_of(std::string_view part, std::string_view text, const Span& span) {
  if (!span.source) return span;
  const std::size_t at = std::string_view(span.source->text).substr(span.begin, span.end - span.begin).find(text);
  if (at == text.npos) return span;
  const auto begin = static_cast<std::uint32_t>(span.begin + at + static_cast<std::size_t>(part.data() - text.data()));
  return {span.source, begin, begin + static_cast<std::uint32_t>(part.size())};
}

/// A number or one character, as behind `x-stitch-number`, or two numbers, as behind `stitch`.
bool is_setting(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash != text.npos) return number_in(text.substr(0, slash)) && number_in(text.substr(slash + 1));
  return text.size() == 1 || number_in(text);
}

}  // namespace

double StitchLengths::at(std::string_view setting) const {
  const auto listed = by_setting.find(setting);
  return listed == by_setting.end() ? otherwise : listed->second;
}

StitchLengths default_stitch_lengths(const Program& program) {
  const double gauge = program.gauge > 0 ? program.gauge : machine_facts(program.machine).gauge;
  if (gauge <= 0) return {};
  StitchLengths lengths{pitches_per_loop * metres_per_inch / gauge, {}};
  if (machine_facts(program.machine).numbers_are_sizes)
    for (int number = 0; number < static_cast<int>(kniterate_numbers.size()); ++number)
      lengths.by_setting[std::string(1, kniterate_numbers[static_cast<std::size_t>(number)])] =
          lengths.otherwise * (1 + kniterate_step * (number - kniterate_middle));
  return lengths;
}

StitchLengths merged(const StitchLengths& given, const StitchLengths& assumed) {
  StitchLengths all = given.otherwise > 0 ? StitchLengths{given.otherwise, {}} : assumed;
  for (const auto& [setting, length] : given.by_setting) all.by_setting[setting] = length;
  return all;
}

bool add_setting(StitchLengths& lengths, std::string_view setting, double length, Span place, Diagnostics& say) {
  if (setting == "otherwise") {
    lengths.otherwise = length;
    return true;
  }
  if (!is_setting(setting)) {
    say.error("S008", place, fmt::format("{} is no stitch setting", quoted(setting)),
              "write it as the program does: 5 or A of `x-stitch-number`, 25/40 of `stitch 25 40`; `otherwise` is for "
              "all others");
    return false;
  }
  lengths.by_setting[std::string(setting)] = length;
  return true;
}

std::optional<double> read_stitch_length(std::string_view text, Span span, Diagnostics& say) {
  return read_quantity(text, span, "a stitch length", dimensions::length,
                       {limits::least_stitch_length, limits::most_stitch_length}, say);
}

std::optional<StitchLengths> parse_stitch_lengths(std::string_view text, Span span, Diagnostics& say) {
  StitchLengths lengths;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string_view part = text.substr(at, comma - at);
    const std::size_t equals = part.find('=');
    const bool listed = equals != part.npos;
    const std::string_view setting = listed ? trimmed(part.substr(0, equals)) : "otherwise";
    const std::string_view length_text = trimmed(listed ? part.substr(equals + 1) : part);
    const auto length = read_stitch_length(length_text, place_of(length_text, text, span), say);
    const Span place = listed ? place_of(setting, text, span) : span;
    if (!length || !add_setting(lengths, setting, *length, place, say)) return std::nullopt;
    at = comma + 1;
  }
  return lengths;
}

}  // namespace wale
