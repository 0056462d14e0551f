#include "compiler/passes/machine_rules.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/passes/program_codes.hpp"

namespace wale {
namespace {

using Answer = std::optional<Fault>;

bool on_slider(const Needle& needle) { return needle.bed == Bed::front_slider || needle.bed == Bed::back_slider; }

/// Where a needle stands along the front bed.
double position(const Needle& needle, double racking) {
  return needle.bed == Bed::back ? needle.index + racking : needle.index;
}

Answer needle_fault(const Needle& needle) {
  if (on_slider(needle))
    return Fault{codes::slider, fmt::format("\"{}\" is a slider, and sliders cannot be simulated yet", print(needle)),
                 "use the needles of the two beds"};
  if (needle.index < -farthest_needle || needle.index > farthest_needle)
    return Fault{codes::needle_out_of_range, fmt::format("\"{}\" lies beyond the end of any bed", print(needle)),
                 fmt::format("number the needles from -{0} to {0}", farthest_needle)};
  return {};
}

Answer transfer_fault(const Instruction& at, double racking) {
  if (auto fault = needle_fault(at.other)) return fault;
  if (at.needle.bed == at.other.bed)
    return Fault{codes::same_bed,
                 fmt::format("\"{}\" and \"{}\" are on the same bed", print(at.needle), print(at.other)),
                 "move loops to the other bed"};
  if (position(at.needle, racking) == position(at.other, racking)) return {};
  return Fault{codes::not_facing,
               fmt::format("\"{}\" does not face \"{}\" at racking {:g}", print(at.needle), print(at.other), racking),
               "rack the beds so that the needles face: front = back + racking"};
}

Answer carrier_fault(const Instruction& at, const Program& program, const MachineState& state) {
  for (std::size_t i = 0; i < at.carriers.size(); ++i) {
    const int carrier = at.carriers[i];
    const std::string& name = program.carriers[static_cast<std::size_t>(carrier)];
    if (std::count(at.carriers.begin(), at.carriers.begin() + static_cast<std::ptrdiff_t>(i), carrier))
      return Fault{codes::carrier_twice, fmt::format("carrier \"{}\" is named twice", name), "name it once"};
    const bool in = state.in[static_cast<std::size_t>(carrier)];
    if (brings_in(at.op) && in)
      return Fault{codes::carrier_already_in, fmt::format("carrier \"{}\" is already in", name),
                   fmt::format("write `out {}` first, or leave this out", name)};
    if ((works_needle(at.op) || takes_out(at.op)) && !in)
      return Fault{codes::carrier_not_in, fmt::format("carrier \"{}\" is not in", name),
                   fmt::format("write `in {}` before this", name)};
  }
  return {};
}

}  // namespace

std::optional<Fault> fault_of(const Instruction& at, const Program& program, const MachineState& state) {
  if (at.carriers.empty() && (brings_in(at.op) || takes_out(at.op)))
    return Fault{codes::carrier_missing, "no carrier is named", "name the carrier"};
  if (auto fault = carrier_fault(at, program, state)) return fault;
  if (!works_needle(at.op)) return {};
  // Miss makes no loop, so it may pass a slider; its needle must still be somewhere on the machine.
  const Needle passed{Bed::front, at.needle.index};
  if (auto fault = needle_fault(at.op == Op::miss ? passed : at.needle)) return fault;
  if (!at.carriers.empty() && at.direction == Direction::none)
    return Fault{codes::direction_missing, "a stitch with yarn needs a direction", "write + or - after the operation"};
  if (at.op == Op::split) return transfer_fault(at, state.racking);
  return {};
}

void follow(const Instruction& at, MachineState& state) {
  if (at.op == Op::rack) state.racking = at.value[0];
  if (brings_in(at.op) || works_needle(at.op))
    for (const int carrier : at.carriers) state.in[static_cast<std::size_t>(carrier)] = true;
  if (takes_out(at.op))
    for (const int carrier : at.carriers) state.in[static_cast<std::size_t>(carrier)] = false;
}

}  // namespace wale
