#include "compiler/passes/machine_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/passes/program_codes.hpp"

namespace wale {
namespace {

using Answer = std::optional<Fault>;

constexpr double farthest_racking = 100;  // needles; far beyond any machine

Answer needle_fault(const Needle& needle) {
  if (needle.index < -farthest_needle || needle.index > farthest_needle)
    return Fault{codes::needle_out_of_range, fmt::format("\"{}\" lies beyond the end of any bed", print(needle)),
                 fmt::format("number the needles from -{0} to {0}", farthest_needle)};
  return {};
}

Answer transfer_fault(const Instruction& at, double racking) {
  if (auto fault = needle_fault(at.other)) return fault;
  if (on_slider(at.needle) && on_slider(at.other))
    return Fault{codes::slider, fmt::format("\"{}\" and \"{}\" are both sliders", print(at.needle), print(at.other)),
                 "move loops between a slider and a needle of the other bed"};
  if (on_back(at.needle) == on_back(at.other))
    return Fault{codes::same_bed,
                 fmt::format("\"{}\" and \"{}\" are on the same bed", print(at.needle), print(at.other)),
                 "move loops to the other bed"};
  if (position(at.needle, racking) == position(at.other, racking)) return {};
  return Fault{codes::not_facing,
               fmt::format("\"{}\" does not face \"{}\" at racking {:g}", print(at.needle), print(at.other), racking),
               "rack the beds so that the needles face: front = back + racking"};
}

Answer racking_fault(const Instruction& at) {
  if (std::abs(at.value[0]) <= farthest_racking) return {};
  return Fault{codes::racking_absurd, fmt::format("no bed can be racked by {:g} needles", at.value[0]),
               fmt::format("rack by at most {:g}; machines allow 4 to 8", farthest_racking)};
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
  if (at.op == Op::rack) return racking_fault(at);
  if (auto fault = carrier_fault(at, program, state)) return fault;
  if (!works_needle(at.op)) return {};
  if (auto fault = needle_fault(at.needle)) return fault;
  if (on_slider(at.needle) && at.op != Op::miss && !at.carriers.empty())
    return Fault{codes::slider,
                 fmt::format("\"{}\" is a slider, which holds loops but cannot make them", print(at.needle)),
                 "make the loop on a needle, then transfer it"};
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
