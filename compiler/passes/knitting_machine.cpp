#include "compiler/passes/knitting_machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/passes/program_codes.hpp"

namespace wale {
namespace {

/// No hook takes so many; what counts here is that a program cannot ask for endless work by moving a mountain.
constexpr std::size_t tallest_stack = 100;
constexpr std::size_t most_ties = 4'000'000;  // loops pulled through loops, and loops moved

bool makes_or_moves_loops(const Instruction& at) {
  return at.op == Op::knit || at.op == Op::split || (at.op == Op::tuck && !at.carriers.empty());
}

}  // namespace

KnittingMachine::KnittingMachine(const Program& program)
    : plating_(program.plating), state_(program), beds_(program), ends_(program.carriers.size()) {
  graph_.carriers = program.carriers;
  graph_.loops.reserve(
      static_cast<std::size_t>(std::count_if(program.code.begin(), program.code.end(), [](const Instruction& at) {
        return works_needle(at.op) && !at.carriers.empty();
      })));
}

std::optional<Fault> KnittingMachine::crowd(const Instruction& at) {
  if (!makes_or_moves_loops(at)) return {};
  const std::size_t here = beds_.at(at.needle).size(), made = at.carriers.size();
  const std::size_t stays = at.op == Op::tuck ? here + made : made;
  const std::size_t there = at.op == Op::split ? here + beds_.at(at.other).size() : 0;
  if (std::max(stays, there) > tallest_stack)
    return Fault{codes::stack_absurd, fmt::format("a needle would hold more than {} loops", tallest_stack),
                 "knit its loops before it takes more"};
  ties_ += at.op == Op::tuck ? 0 : here * (made + (at.op == Op::split ? 1 : 0));
  if (ties_ > most_ties)
    return Fault{codes::too_many_ties,
                 fmt::format("by here more than {} loops have been knitted through or moved", most_ties),
                 "cut the program into several"};
  return {};
}

void KnittingMachine::run(const Instruction& at, int instruction) {
  now_ = instruction;
  if (brings_in(at.op)) bring_in(at);
  follow(at, state_);
  if (takes_out(at.op))
    for (const int carrier : at.carriers) take_out(end_of(carrier), now_);
  if (!works_needle(at.op)) return;
  if (makes_or_moves_loops(at)) {
    const int before = in_use(at);
    stitch(at);
    needles_in_use_ += in_use(at) - before;
    graph_.widest = std::max(graph_.widest, needles_in_use_);
  }
  if (at.op == Op::split) drag(at);
  if (at.op == Op::miss)
    for (const int carrier : at.carriers) miss(at, end_of(carrier));
}

StitchGraph KnittingMachine::finish() {
  for (YarnEnd& end : ends_) take_out(end, -1);
  graph_.on_needles = beds_.held();
  for (const HeldLoops& needle : graph_.on_needles)
    for (const int loop : needle.loops) {
      loop_at(loop).held = true;
      loop_at(loop).last_racking = state_.racking;
    }
  return std::move(graph_);
}

/// How many of the needles that an instruction works hold loops.
int KnittingMachine::in_use(const Instruction& at) {
  return (beds_.at(at.needle).empty() ? 0 : 1) + (at.op != Op::split || beds_.at(at.other).empty() ? 0 : 1);
}

void KnittingMachine::bring_in(const Instruction& at) {
  for (const int carrier : at.carriers) {
    if (state_.in[static_cast<std::size_t>(carrier)]) continue;
    end_of(carrier) = {};
    end_of(carrier).came_in = now_;
  }
}

void KnittingMachine::take_out(YarnEnd& end, int instruction) {
  if (end.yarn >= 0) {
    YarnPath& yarn = graph_.yarns[static_cast<std::size_t>(end.yarn)];
    yarn.went_out = instruction;
    yarn.end = end.stop;
  }
  end = {};
}

/// A new pass begins where the yarn turns, or comes back to a needle that it has passed.
void KnittingMachine::pass(const Instruction& at, YarnEnd& end) const {
  const double there = position(at.needle, state_.racking);
  const double ahead = at.direction == Direction::increasing ? there - end.position : end.position - there;
  const bool again = ahead < 0 || (ahead == 0 && at.needle.bed == end.bed);
  if (end.direction != Direction::none && (at.direction != end.direction || again)) ++end.course;
  end.direction = at.direction;
  end.position = there;
  end.bed = at.needle.bed;
  end.stop = {at.needle, at.direction};
}

void KnittingMachine::miss(const Instruction& at, YarnEnd& end) {
  auto& misses = end.yarn < 0 ? end.misses : graph_.yarns[static_cast<std::size_t>(end.yarn)].misses;
  const auto loops = end.yarn < 0 ? 0 : graph_.yarns[static_cast<std::size_t>(end.yarn)].loops.size();
  misses.push_back({static_cast<int>(loops), at.needle, at.direction, state_.racking, now_});
  pass(at, end);
}

/// Of several yarns that knit as one, in the order in which they lie from front to back.
std::vector<int> KnittingMachine::by_depth(std::vector<int> carriers) const {
  if (plating_ == Plating::first_behind) std::reverse(carriers.begin(), carriers.end());
  return carriers;
}

void KnittingMachine::stitch(const Instruction& at) {
  LoopStack& stack = beds_.at(at.needle);
  LoopStack through;
  if (at.op != Op::tuck && !at.carriers.empty()) through = front_to_back(at.needle, stack);
  if (at.op == Op::split) move(stack, at.other);
  if (at.op == Op::knit) release(stack, !at.carriers.empty());
  if (at.op != Op::tuck) stack.clear();
  const auto first = static_cast<int>(graph_.loops.size());
  for (const int carrier : by_depth(at.carriers)) {
    stack.push_back(static_cast<int>(graph_.loops.size()));
    make_loop(at, carrier, through);
  }
  for (const int loop : through) pulled_through_[static_cast<std::size_t>(loop)] = true;
  const auto made = static_cast<std::ptrdiff_t>(graph_.loops.size()) - first;
  if (on_back(at.needle)) std::reverse(stack.end() - made, stack.end());
}

void KnittingMachine::move(const LoopStack& stack, const Needle& needle) {
  LoopStack& to = beds_.at(needle);
  to.insert(to.end(), stack.rbegin(), stack.rend());
  for (const int loop : stack) {
    loop_at(loop).moves.push_back({needle, state_.racking, now_});
    loop_at(loop).last_needle = needle;
  }
}

void KnittingMachine::release(const LoopStack& stack, bool knitted) {
  for (const int loop : stack) {
    loop_at(loop).released = now_;
    loop_at(loop).last_racking = state_.racking;
    loop_at(loop).dropped = !knitted && !pulled_through_[static_cast<std::size_t>(loop)];
  }
}

/// Transfers take along the carriers that wait at the needle, except those that stitch there now.
void KnittingMachine::drag(const Instruction& at) {
  for (std::size_t carrier = 0; carrier < ends_.size(); ++carrier) {
    Stop& stop = ends_[carrier].stop;
    const bool waits = stop.side != Direction::none && stop.needle == at.needle;
    if (waits && std::find(at.carriers.begin(), at.carriers.end(), static_cast<int>(carrier)) == at.carriers.end())
      stop.needle = at.other;
  }
}

void KnittingMachine::make_loop(const Instruction& at, int carrier, std::vector<int> through) {
  YarnEnd& end = end_of(carrier);
  const Stop from = end.stop;
  pass(at, end);
  if (end.yarn < 0) begin_yarn(carrier, end);
  graph_.yarns[static_cast<std::size_t>(end.yarn)].loops.push_back(static_cast<int>(graph_.loops.size()));
  Loop& loop = graph_.loops.emplace_back();
  pulled_through_.push_back(false);
  loop.kind = at.op == Op::tuck ? LoopKind::tuck : LoopKind::knit;
  loop.needle = loop.last_needle = at.needle;
  loop.direction = at.direction;
  loop.carrier = carrier;
  loop.course = end.course;
  loop.through = std::move(through);
  loop.cell = at.cell;
  loop.stitch_length = at.stitch_length;
  loop.span = at.span;
  loop.instruction = now_;
  loop.racking = state_.racking;
  loop.from = from;
}

void KnittingMachine::begin_yarn(int carrier, YarnEnd& end) {
  end.yarn = static_cast<int>(graph_.yarns.size());
  graph_.yarns.push_back({carrier, {}, std::move(end.misses), end.came_in, -1, {}});
  end.misses.clear();
}

}  // namespace wale
