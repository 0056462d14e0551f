#include <algorithm>
#include <utility>
#include <vector>

#include "compiler/passes.hpp"
#include "compiler/passes/knitting_machine.hpp"

namespace wale::passes {
namespace {

bool on_the_beds(const Instruction& at) {
  const auto near = [](const Needle& needle) {
    return needle.index >= -farthest_needle && needle.index <= farthest_needle;
  };
  return near(at.needle) && (at.op != Op::split || near(at.other));
}

/// Each carrier once, some direction, and no transfer of a needle to itself.
Instruction mended(Instruction at) {
  if (at.op == Op::split && at.needle == at.other) at.op = at.carriers.empty() ? Op::tuck : Op::knit;
  std::vector<int> once;
  for (const int carrier : at.carriers)
    if (std::find(once.begin(), once.end(), carrier) == once.end()) once.push_back(carrier);
  at.carriers = std::move(once);
  if (at.direction == Direction::none) at.direction = Direction::increasing;
  return at;
}

}  // namespace

std::optional<StitchGraph> knit(const Program& program, Diagnostics& say) {
  KnittingMachine machine(program);
  for (std::size_t i = 0; i < program.code.size(); ++i) {
    const Instruction& at = program.code[i];
    auto fault = fault_of(at, program, machine.state());
    if (!fault) fault = machine.crowd(at);
    if (fault) {
      // What would follow a stitch that cannot be made is anyone's guess, so the machine stops here.
      say.error(fault->code, at.span, std::move(fault->message), std::move(fault->hint));
      return {};
    }
    machine.run(at, static_cast<int>(i));
  }
  return machine.finish();
}

StitchGraph knit_all(const Program& program) {
  KnittingMachine machine(program);
  for (std::size_t i = 0; i < program.code.size(); ++i) {
    const Instruction& at = program.code[i];
    const bool faulty = fault_of(at, program, machine.state()).has_value();
    if (!on_the_beds(at) || machine.crowd(at)) continue;
    machine.run(faulty ? mended(at) : at, static_cast<int>(i));
  }
  return machine.finish();
}

}  // namespace wale::passes
