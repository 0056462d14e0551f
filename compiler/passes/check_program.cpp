#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "compiler/passes.hpp"
#include "compiler/passes/machine_rules.hpp"
#include "compiler/passes/program_codes.hpp"

namespace wale::passes {
namespace {

constexpr double most_racking = 4;  // needles; what common machines allow

/// What a carrier does between coming in and going out.
struct Visit {
  Span came_in;
  bool in = false, stitched = false;
};

class Checking {
 public:
  Checking(const Program& program, Diagnostics& say)
      : program_(program), say_(say), state_(program), visits_(program.carriers.size()) {}

  void run() {
    for (const Instruction& at : program_.code) {
      if (auto fault = fault_of(at, program_, state_))
        say_.error(fault->code, at.span, std::move(fault->message), std::move(fault->hint));
      follow(at, state_);
      if (at.op == Op::rack) check_racking(at);
      for (const int carrier : at.carriers) follow_carrier(at, carrier);
    }
    for (std::size_t carrier = 0; carrier < visits_.size(); ++carrier)
      if (visits_[carrier].in)
        say_.warning(codes::carrier_left_in, visits_[carrier].came_in,
                     fmt::format("carrier \"{}\" is still in at the end", program_.carriers[carrier]),
                     fmt::format("write `out {}` after its last stitch", program_.carriers[carrier]));
  }

 private:
  void check_racking(const Instruction& at) {
    if (std::abs(at.value[0]) <= most_racking) return;
    say_.warning(codes::racked_far, at.span,
                 fmt::format("the bed is racked by {:g} needles; most machines allow {:g}", at.value[0], most_racking),
                 "reach far needles by several transfers");
  }

  void follow_carrier(const Instruction& at, int carrier) {
    Visit& visit = visits_[static_cast<std::size_t>(carrier)];
    if (brings_in(at.op)) visit = {at.span, true, false};
    if (at.op == Op::knit || at.op == Op::tuck || at.op == Op::split) visit.stitched = true;
    if (!takes_out(at.op)) return;
    if (visit.in && !visit.stitched)
      say_.warning(
          codes::carrier_unused, visit.came_in,
          fmt::format("carrier \"{}\" comes in and never knits", program_.carriers[static_cast<std::size_t>(carrier)]),
          "knit with it, or leave it out");
    visit.in = false;
  }

  const Program& program_;
  Diagnostics& say_;
  MachineState state_;
  std::vector<Visit> visits_;  // by carrier
};

}  // namespace

void check_program(const Program& program, Diagnostics& say) { Checking(program, say).run(); }

}  // namespace wale::passes
