#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "compiler/passes.hpp"
#include "compiler/passes/machine_rules.hpp"

namespace wale::passes {
namespace {

/// The loops on a needle from the hook's base to its tip: what comes later lies nearer the gap between the beds.
using Stack = std::vector<int>;

/// The loops of every needle that a program names, in one flat array a bed.
class Beds {
 public:
  explicit Beds(const Program& program) {
    int last = std::numeric_limits<int>::min();
    first_ = std::numeric_limits<int>::max();
    for (const Instruction& at : program.code) {
      if (!works_needle(at.op)) continue;
      // What lies farther out is refused before it is asked for.
      for (const int index : {at.needle.index, at.op == Op::split ? at.other.index : at.needle.index}) {
        first_ = std::min(first_, std::max(index, -farthest_needle));
        last = std::max(last, std::min(index, farthest_needle));
      }
    }
    const auto width = static_cast<std::size_t>(std::max(0L, static_cast<long>(last) - first_ + 1));
    front_.resize(width);
    back_.resize(width);
  }

  Stack& at(const Needle& needle) {
    return (needle.bed == Bed::front ? front_ : back_)[static_cast<std::size_t>(needle.index - first_)];
  }

  template <class F>
  void for_each_loop(F&& visit) const {
    for (const auto* bed : {&front_, &back_})
      for (const Stack& stack : *bed)
        for (const int loop : stack) visit(loop);
  }

 private:
  int first_ = 0;
  std::vector<Stack> front_, back_;
};

/// Seen from the front: front hooks open to the back, so that the base lies foremost; back hooks the other way.
std::vector<int> front_to_back(const Needle& needle, const Stack& stack) {
  return needle.bed == Bed::front ? stack : Stack(stack.rbegin(), stack.rend());
}

class Machine {
 public:
  explicit Machine(const Program& program) : state_(program), beds_(program), ends_(program.carriers.size()) {
    graph_.carriers = program.carriers;
    graph_.loops.reserve(program.code.size());
  }

  const MachineState& state() const { return state_; }

  void run(const Instruction& at) {
    follow(at, state_);
    if (brings_in(at.op))
      for (const int carrier : at.carriers) end_of(carrier) = {};
    if (!works_needle(at.op)) return;
    for (const int carrier : at.carriers) pass(at, end_of(carrier));
    if (at.op == Op::miss || (at.op == Op::tuck && at.carriers.empty())) return;
    stitch(at);
  }

  StitchGraph finish() {
    beds_.for_each_loop([this](int loop) { graph_.loops[static_cast<std::size_t>(loop)].held = true; });
    return std::move(graph_);
  }

 private:
  /// Where a carrier is, and how often it turned on the way.
  struct YarnEnd {
    int yarn = -1;  // index into StitchGraph::yarns, once it has made a loop
    int course = 0;
    Direction direction = Direction::none;
    double position = 0;
    Bed bed = Bed::front;
  };

  YarnEnd& end_of(int carrier) { return ends_[static_cast<std::size_t>(carrier)]; }

  /// A new pass begins where the yarn turns, or comes back to a needle that it has passed.
  void pass(const Instruction& at, YarnEnd& end) const {
    const double position = at.needle.index + (at.needle.bed == Bed::back ? state_.racking : 0);
    const double ahead = at.direction == Direction::increasing ? position - end.position : end.position - position;
    const bool again = ahead < 0 || (ahead == 0 && at.needle.bed == end.bed);
    const bool turned = end.direction != Direction::none && (at.direction != end.direction || again);
    end = {end.yarn, end.course + (turned ? 1 : 0), at.direction, position, at.needle.bed};
  }

  void stitch(const Instruction& at) {
    Stack& stack = beds_.at(at.needle);
    std::vector<int> through;
    if (at.op != Op::tuck && !at.carriers.empty()) through = front_to_back(at.needle, stack);
    if (at.op == Op::split) {
      Stack& to = beds_.at(at.other);
      to.insert(to.end(), stack.rbegin(), stack.rend());
    }
    if (at.op != Op::tuck) stack.clear();
    const auto first = static_cast<int>(graph_.loops.size());
    for (const int carrier : at.carriers) {
      stack.push_back(static_cast<int>(graph_.loops.size()));
      make_loop(at, carrier, through);
    }
    // Of several yarns that knit as one the first named lies foremost.
    const auto made = static_cast<std::ptrdiff_t>(graph_.loops.size()) - first;
    if (at.needle.bed == Bed::back) std::reverse(stack.end() - made, stack.end());
  }

  void make_loop(const Instruction& at, int carrier, std::vector<int> through) {
    YarnEnd& end = end_of(carrier);
    if (end.yarn < 0) {
      end.yarn = static_cast<int>(graph_.yarns.size());
      graph_.yarns.push_back({carrier, {}});
    }
    graph_.yarns[static_cast<std::size_t>(end.yarn)].loops.push_back(static_cast<int>(graph_.loops.size()));
    Loop& loop = graph_.loops.emplace_back();
    loop.kind = at.op == Op::tuck ? LoopKind::tuck : LoopKind::knit;
    loop.needle = at.needle;
    loop.direction = at.direction;
    loop.carrier = carrier;
    loop.course = end.course;
    loop.through = std::move(through);
    loop.cell = at.cell;
    loop.stitch_length = at.stitch_length;
    loop.span = at.span;
  }

  MachineState state_;
  Beds beds_;
  std::vector<YarnEnd> ends_;  // by carrier
  StitchGraph graph_;
};

}  // namespace

std::optional<StitchGraph> knit(const Program& program, Diagnostics& say) {
  Machine machine(program);
  for (const Instruction& at : program.code) {
    if (auto fault = fault_of(at, program, machine.state())) {
      // What would follow a stitch that cannot be made is anyone's guess, so the machine stops here.
      say.error(fault->code, at.span, std::move(fault->message), std::move(fault->hint));
      return {};
    }
    machine.run(at);
  }
  return machine.finish();
}

}  // namespace wale::passes
