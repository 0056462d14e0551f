#include <fmt/format.h>

#include <string>

#include "compiler/passes.hpp"

namespace wale::passes {
namespace {

constexpr std::string_view stitch_number = "x-stitch-number";

/// The number in `x-stitch-number 5`; of any other extension nothing.
std::string_view number_of(std::string_view extension) {
  if (!extension.starts_with(stitch_number)) return {};
  constexpr std::string_view blanks = " \t";
  const std::size_t first = extension.find_first_of(blanks);
  if (first != stitch_number.size()) return {};
  return extension.substr(extension.find_first_not_of(blanks, first));
}

}  // namespace

void set_stitch_lengths(Program& program, const StitchLengths& lengths) {
  double length = lengths.otherwise;
  for (Instruction& at : program.code) {
    if (at.op == Op::stitch) length = lengths.at(fmt::format("{}/{}", at.value[0], at.value[1]));
    if (at.op == Op::extension) {
      const std::string_view number = number_of(program.extensions[static_cast<std::size_t>(at.extension)]);
      if (!number.empty()) length = lengths.at(number);
    }
    if ((at.op == Op::knit || at.op == Op::tuck || at.op == Op::split) && !at.carriers.empty())
      at.stitch_length = length;
  }
}

}  // namespace wale::passes
