#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compiler/front/knitout_codes.hpp"
#include "compiler/front/knitout_parts.hpp"
#include "compiler/front/limits.hpp"
#include "compiler/spelling.hpp"

namespace wale {
namespace {

constexpr std::array<std::string_view, 4> positions{"Left", "Center", "Right", "Keep"};
const std::vector<std::string_view> known_headers{"Carriers", "Machine", "Gauge", "Position", "Width", "Presser"};

bool read_carrier(std::string_view name, KnitoutReading& reading) {
  const auto& known = reading.program.carriers;
  if (std::find(known.begin(), known.end(), name) == known.end()) return add_carrier(name, reading).has_value();
  reading.say.error(codes::carriers_header, reading.span_of(name),
                    fmt::format("carrier {} is declared twice", quoted(name)), "name every carrier once");
  return true;
}

/// Rails from front to back; those that share a rail stand as `L1,L2;R1`, the left group first.
void read_carriers(std::string_view value, KnitoutReading& reading) {
  constexpr std::string_view between = " \t,;";
  reading.has_carriers = true;
  reading.program.carriers.clear();
  reading.program.rails = value.find_first_of(",;") == value.npos ? "" : value;
  for (std::size_t at = value.find_first_not_of(between); at != value.npos;) {
    const std::size_t end = std::min(value.find_first_of(between, at), value.size());
    if (!read_carrier(value.substr(at, end - at), reading)) return;
    at = value.find_first_not_of(between, end);
  }
}

void read_gauge(std::string_view value, KnitoutReading& reading) {
  const auto number = number_in(value);
  if (number && *number > 0 && *number <= limits::finest_gauge)
    reading.program.gauge = *number;
  else
    reading.say.warning(codes::header_value, reading.span_of(value), fmt::format("{} is no gauge", quoted(value)),
                        "write the needles per inch: `;;Gauge: 15`");
}

void read_position(std::string_view value, KnitoutReading& reading) {
  if (std::find(positions.begin(), positions.end(), value) != positions.end())
    reading.program.position = value;
  else
    reading.say.warning(codes::header_value, reading.span_of(value), fmt::format("{} is no position", quoted(value)),
                        "write Left, Center, Right or Keep");
}

void keep_header(std::string_view name, std::string_view value, KnitoutReading& reading) {
  auto& headers = reading.program.headers;
  std::erase_if(headers, [&](const Header& one) { return one.name == name; });
  if (headers.size() < limits::most_headers) headers.push_back({std::string(name), std::string(value)});
  const bool known = name.starts_with("Yarn-") || name.starts_with("X-") ||
                     std::find(known_headers.begin(), known_headers.end(), name) != known_headers.end();
  if (!known && reading.say.keeps(codes::unknown_header))
    reading.say.warning(codes::unknown_header, reading.span_of(name),
                        fmt::format("nobody knows the header {}", quoted(name)), suggest(name, known_headers));
}

void take(std::string_view name, std::string_view value, KnitoutReading& reading) {
  if (!reading.headers_seen.insert(std::string(name)).second)
    reading.say.warning(codes::header_twice, reading.span_of(name),
                        fmt::format("the header {} is given twice; the last one counts", quoted(name)),
                        "remove one of the two");
  if (name == "Carriers")
    read_carriers(value, reading);
  else if (name == "Machine")
    reading.program.machine = value;
  else if (name == "Gauge")
    read_gauge(value, reading);
  else if (name == "Position")
    read_position(value, reading);
  else
    keep_header(name, value, reading);
}

}  // namespace

std::optional<int> add_carrier(std::string_view name, KnitoutReading& reading) {
  auto& carriers = reading.program.carriers;
  const bool long_name = name.size() > limits::longest_name;
  if (name.find_first_of(",;") != name.npos) {
    reading.say.error(
        codes::carriers_header, reading.span_of(name), fmt::format("{} is no carrier's name", quoted(name)),
        "separate carriers by blanks; commas and semicolons tell the carriers of a rail apart in the header");
    return std::nullopt;
  }
  if (long_name || carriers.size() == limits::most_carriers) {
    reading.say.error(codes::carriers_header, reading.span_of(name),
                      long_name ? fmt::format("{} is too long for a carrier's name", quoted(name))
                                : fmt::format("there are more than {} carriers", limits::most_carriers),
                      "name those that the program uses, as the machine does");
    return std::nullopt;
  }
  carriers.emplace_back(name);
  return static_cast<int>(carriers.size()) - 1;
}

bool read_header(std::string_view line, KnitoutReading& reading) {
  if (!line.starts_with(";;")) return false;
  const std::size_t colon = line.find(':');
  const bool spaced = colon != line.npos && (colon + 1 == line.size() || line[colon + 1] == ' ');
  if (colon == 2 || !spaced) {
    reading.say.warning(codes::no_header, reading.span_of(line.substr(0, 80)), "this is no header, but a comment",
                        "write `;;Name: value`, with a space after the colon");
    return true;
  }
  take(line.substr(2, colon - 2), trimmed(line.substr(colon + 1)), reading);
  return true;
}

}  // namespace wale
