#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "compiler/front/knitout_codes.hpp"
#include "compiler/front/knitout_parts.hpp"
#include "compiler/front/limits.hpp"
#include "compiler/passes.hpp"

namespace wale {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view magic = ";!knitout-";
constexpr int known_version = 2;

/// Gives the lines of a text one by one, without their ends.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  bool at_end() const { return rest_.empty(); }
  std::string_view next() {
    const std::size_t length = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, length);
    rest_.remove_prefix(std::min(length + 1, rest_.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

 private:
  std::string_view rest_;
};

void check_bytes(std::string_view text, KnitoutReading& reading) {
  if (text.starts_with(byte_order_mark))
    reading.say.warning(codes::not_plain_text, reading.span_of(text.substr(0, byte_order_mark.size())),
                        "the file begins with a byte order mark", "save as UTF-8 without one");
  if (const std::size_t at = text.find("\r\n"); at != text.npos)
    reading.say.warning(codes::not_plain_text, reading.span_of(text.substr(at, 1)),
                        "the lines end with a carriage return", "save with line ends as on Unix");
  if (const std::size_t at = text.find('\0'); at != text.npos)
    reading.say.error(codes::nul_byte, reading.span_of(text.substr(at, 1)), "a NUL byte: this is no text",
                      "save as UTF-8");
}

bool all_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// True if the line was meant as the magic line; what it says of the version is then known.
bool read_magic(std::string_view line, KnitoutReading& reading) {
  const bool meant = line.starts_with(";!knitout");
  const std::string_view version = trimmed(line.substr(std::min(magic.size(), line.size())));
  if (!line.starts_with(magic) || !all_digits(version)) {
    reading.say.error(codes::not_knitout, reading.span_of(line), "the first line does not say that this is knitout",
                      "write `;!knitout-2` on a line of its own, before all others");
    return meant;
  }
  const char* end = version.data() + version.size();
  if (std::from_chars(version.data(), end, reading.program.version).ec != std::errc{})
    reading.program.version = std::numeric_limits<int>::max();
  if (reading.program.version > known_version)
    reading.say.warning(codes::newer_version, reading.span_of(version),
                        fmt::format("version {} is newer than any known here", reading.program.version),
                        fmt::format("it is read as version {}", known_version));
  return true;
}

void read_lines(std::string_view text, KnitoutReading& reading) {
  Lines lines(text);
  std::string_view line = lines.next();
  bool more = true;
  const auto step = [&] { (more = !lines.at_end()) ? line = lines.next() : line; };
  if (read_magic(line, reading)) step();
  while (more && read_header(line, reading)) step();
  if (!reading.has_carriers)
    reading.say.warning(codes::no_carriers_header, reading.span_of(line.substr(0, 0)), "no header names the carriers",
                        "write `;;Carriers: 1 2 3` before the first operation");
  for (; more; step()) {
    if (reading.program.code.size() == limits::most_instructions) {
      reading.say.error(codes::program_too_long, reading.span_of(line),
                        fmt::format("the program is longer than {} instructions", limits::most_instructions),
                        "cut the file into several");
      return;
    }
    read_operation(line, reading);
  }
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
  const std::size_t last = text.find_last_not_of(blanks);
  return last == text.npos ? text.substr(0, 0) : text.substr(first, last + 1 - first);
}

std::optional<double> number_in(std::string_view word) {
  // from_chars takes a minus only.
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const char* end = word.data() + word.size();
  const auto [stopped, failed] = std::from_chars(word.data(), end, value);
  if (failed != std::errc{} || stopped != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text = "\"";
  for (const char c : word.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte < ' ' ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
  }
  return text + (word.size() > longest ? "...\"" : "\"");
}

Program passes::parse_knitout(const Source& source, Diagnostics& say) {
  KnitoutReading reading{source, say, {}, false, {}, {}, {}, {}};
  std::string_view text = source.text;
  check_bytes(text, reading);
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  read_lines(text, reading);
  return std::move(reading.program);
}

}  // namespace wale
