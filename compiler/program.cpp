#include "compiler/program.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <string_view>

namespace wale {
namespace {

constexpr std::array<std::string_view, 4> bed_names{"f", "b", "fs", "bs"};
constexpr std::array<std::string_view, 12> op_names{"in",   "inhook", "releasehook", "out",  "outhook", "knit",
                                                    "tuck", "split",  "miss",        "rack", "stitch",  "pause"};

/// Knit, tuck and split have their own names when neither yarn nor a direction is given.
std::string_view name_of(const Instruction& at) {
  if (at.carriers.empty() && at.direction == Direction::none) {
    if (at.op == Op::knit) return "drop";
    if (at.op == Op::tuck) return "amiss";
    if (at.op == Op::split) return "xfer";
  }
  return op_names[static_cast<std::size_t>(at.op)];
}

std::string print_head(const Program& program) {
  std::string text = fmt::format(";!knitout-{}\n;;Carriers:", program.version);
  if (!program.rails.empty()) text += " " + program.rails;
  if (program.rails.empty())
    for (const std::string& carrier : program.carriers) text += " " + carrier;
  text += "\n";
  const auto add = [&](std::string_view name, std::string_view value) {
    if (!value.empty()) fmt::format_to(std::back_inserter(text), ";;{}: {}\n", name, value);
  };
  add("Machine", program.machine);
  add("Gauge", program.gauge > 0 ? fmt::format("{}", program.gauge) : "");
  add("Position", program.position);
  for (const Header& header : program.headers) add(header.name, header.value);
  return text;
}

}  // namespace

std::string print(const Needle& needle) {
  return fmt::format("{}{}", bed_names[static_cast<std::size_t>(needle.bed)], needle.index);
}

std::string print(const Instruction& at, const Program& program) {
  if (at.op == Op::extension) return program.extensions[static_cast<std::size_t>(at.extension)];
  std::string line{name_of(at)};
  const bool at_needle = at.op == Op::knit || at.op == Op::tuck || at.op == Op::split || at.op == Op::miss;
  if (at_needle && (!at.carriers.empty() || at.op == Op::miss || at.direction != Direction::none))
    line += at.direction == Direction::decreasing ? " -" : " +";
  if (at_needle) line += " " + print(at.needle);
  if (at.op == Op::split) line += " " + print(at.other);
  if (at.op == Op::rack) line += fmt::format(" {}", at.value[0]);
  if (at.op == Op::stitch) line += fmt::format(" {} {}", at.value[0], at.value[1]);
  for (const int carrier : at.carriers) line += " " + program.carriers[static_cast<std::size_t>(carrier)];
  return line;
}

std::string print(const Program& program) {
  std::string text = print_head(program);
  int course = -1;
  for (const Instruction& at : program.code) {
    if (at.cell.course > course)
      fmt::format_to(std::back_inserter(text), "; course {}\n", (course = at.cell.course) + 1);
    text += print(at, program);
    text += "\n";
  }
  return text;
}

}  // namespace wale
