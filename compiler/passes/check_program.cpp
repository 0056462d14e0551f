#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "compiler/machines.hpp"
#include "compiler/passes.hpp"
#include "compiler/passes/finding.hpp"
#include "compiler/passes/machine_rules.hpp"
#include "compiler/passes/program_codes.hpp"

namespace wale::passes {
namespace {

/// What a carrier does between coming in and going out.
struct Visit {
  Span came_in;
  bool in = false, stitched = false;
};

class Checking {
 public:
  Checking(const Program& program, Diagnostics& say)
      : program_(program),
        say_(say),
        state_(program),
        visits_(program.carriers.size()),
        most_racking_(machine_facts(program.machine).most_racking) {}

  void run() {
    for (const Instruction& at : program_.code) {
      if (auto fault = fault_of(at, program_, state_))
        say_.error(fault->code, at.span, std::move(fault->message), std::move(fault->hint));
      follow(at, state_);
      if (at.op == Op::rack) check_racking(at);
      if (at.op == Op::miss && at.carriers.empty()) idle_misses_.add(at.span);
      follow_hook(at);
      for (const int carrier : at.carriers) follow_carrier(at, carrier);
    }
    tell_once(idle_misses_, Severity::warning, codes::miss_without_yarn, "no carrier is named, so nothing moves",
              "name the carrier that passes the needle", say_);
    for (std::size_t carrier = 0; carrier < visits_.size(); ++carrier)
      if (visits_[carrier].in)
        say_.warning(codes::carrier_left_in, visits_[carrier].came_in,
                     fmt::format("carrier \"{}\" is still in at the end", program_.carriers[carrier]),
                     fmt::format("write `out {}` after its last stitch", program_.carriers[carrier]));
  }

 private:
  void check_racking(const Instruction& at) {
    if (std::abs(at.value[0]) <= most_racking_) return;
    say_.warning(codes::racked_far, at.span,
                 fmt::format("the bed is racked by {:g} needles; {} {:g}", at.value[0],
                             program_.machine.empty() ? "most machines allow" : "this machine allows", most_racking_),
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

  /// The inserting hook holds the ends of what came in last, until they are stitched and it is released.
  void follow_hook(const Instruction& at) {
    const bool takes = at.op == Op::inhook, cuts = at.op == Op::outhook;
    if ((takes || cuts) && !hook_.empty())
      say_.warning(codes::hook_busy, at.span, "the hook still holds another yarn",
                   fmt::format("write `releasehook {}` before", program_.carriers[static_cast<std::size_t>(hook_[0])]));
    if (takes) hook_ = at.carriers;
    if (at.op != Op::releasehook) return;
    check_release(at);
    hook_.clear();
  }

  void check_release(const Instruction& at) {
    const auto stitched = [&](int carrier) { return visits_[static_cast<std::size_t>(carrier)].stitched; };
    std::string_view wrong;
    if (hook_.empty())
      wrong = "the hook is empty";
    else if (at.carriers != hook_)
      wrong = "the hook holds other carriers";
    else if (!std::all_of(hook_.begin(), hook_.end(), stitched))
      wrong = "the yarn in the hook has not been stitched yet";
    if (!wrong.empty())
      say_.warning(codes::hook_release, at.span, std::string(wrong),
                   "release what came in by `inhook`, after its first stitches");
  }

  const Program& program_;
  Diagnostics& say_;
  MachineState state_;
  std::vector<Visit> visits_;  // by carrier
  std::vector<int> hook_;      // carriers
  double most_racking_;        // needles
  Finding idle_misses_;
};

}  // namespace

void check_program(const Program& program, Diagnostics& say) { Checking(program, say).run(); }

}  // namespace wale::passes
