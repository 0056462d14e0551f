/// What a V-bed machine cannot do, one instruction at a time; check_program and knit ask the same rules.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/program.hpp"

namespace wale {

/// As much of the machine as the rules need to know. The beds face each other at F = B + racking.
struct MachineState {
  explicit MachineState(const Program& program) : in(program.carriers.size(), false) {}
  std::vector<bool> in;  ///< by carrier
  double racking = 0;    ///< needles by which the back bed stands to the right
};

/// Why an instruction cannot be done.
struct Fault {
  std::string_view code;
  std::string message, hint;
};

inline constexpr int farthest_needle = 100000;

std::optional<Fault> fault_of(const Instruction&, const Program&, const MachineState&);
/// Carriers come in and go out, the bed is racked. After a fault this goes on as if the instruction could be done.
void follow(const Instruction&, MachineState&);

inline bool works_needle(Op op) { return op == Op::knit || op == Op::tuck || op == Op::split || op == Op::miss; }
inline bool brings_in(Op op) { return op == Op::in || op == Op::inhook; }
inline bool takes_out(Op op) { return op == Op::out || op == Op::outhook; }

}  // namespace wale
