#include "compiler/stitch_lengths.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/front/knitout_codes.hpp"
#include "compiler/front/limits.hpp"
#include "compiler/machines.hpp"
#include "compiler/units.hpp"

namespace wale {
namespace {

constexpr double metres_per_inch = 0.0254;
constexpr double pitches_per_loop = 3;
constexpr double kniterate_step = 0.06;  // of the middle length, by number
constexpr int kniterate_middle = 5;
constexpr std::string_view kniterate_numbers = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";

std::string_view trim(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

std::optional<double> parse_length(std::string_view text, const Span& span, Diagnostics& say) {
  const auto length = parse_quantity(text, dimensions::length, span, say);
  if (!length || (*length >= limits::least_stitch_length && *length <= limits::most_stitch_length)) return length;
  say.error("U005", span, fmt::format("a stitch length of {} cannot be meant", text), "write a length like 9 mm");
  return std::nullopt;
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

std::optional<StitchLengths> parse_stitch_lengths(std::string_view text, Span span, Diagnostics& say) {
  StitchLengths lengths;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string_view part = text.substr(at, comma - at);
    const std::size_t equals = part.find('=');
    const auto length = parse_length(trim(equals == part.npos ? part : part.substr(equals + 1)), span, say);
    if (!length) return std::nullopt;
    (equals == part.npos ? lengths.otherwise : lengths.by_setting[std::string(trim(part.substr(0, equals)))]) = *length;
    at = comma + 1;
  }
  return lengths;
}

}  // namespace wale
