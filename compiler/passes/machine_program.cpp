#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "compiler/passes.hpp"
#include "compiler/passes/machine_rules.hpp"
#include "compiler/passes/program_codes.hpp"

namespace wale::passes {
namespace {

constexpr std::string_view stitch_sizes = "0123456789ABCDEF";

/// Takes a lowered chart's program, and puts round it what a machine needs to begin and to end.
class Dressing {
 public:
  Dressing(const Chart& chart, const Program& lowered, const Target& target)
      : chart_(chart), lowered_(lowered), target_(target) {
    write_head();
    sizes_ = machine_facts(target.machine).numbers_are_sizes ? default_stitch_lengths(made_) : StitchLengths{};
  }

  Program run() {
    for (std::size_t i = 0; i < lowered_.code.size(); ++i) {
      if (i + 1 == lowered_.code.size() && chart_.end == Edge::bind_off) bind_off();
      if (i > 0) hang_over(lowered_.code[i]);
      add(lowered_.code[i]);
      if (i == 0 && chart_.start == Edge::cast_on) cast_on();
    }
    return std::move(made_);
  }

 private:
  /// A loop of the first or of the last course: where, which way, by which yarn.
  using Knits = std::vector<const Instruction*>;

  void write_head() {
    made_.machine = target_.machine;
    made_.gauge = target_.gauge;
    made_.position = "Center";
    for (int i = 1; i <= target_.carriers; ++i) made_.carriers.push_back(std::to_string(i));
    for (std::size_t i = 0; i < chart_.yarns.size(); ++i)
      made_.headers.push_back(
          {"Yarn-" + made_.carriers[i],
           fmt::format("{}, {:.4g} tex", chart_.yarns[i].name, chart_.yarns[i].material.linear_density * 1e6)});
  }

  Knits knits_of(int course) const {
    Knits knits;
    for (const Instruction& at : lowered_.code)
      if (at.cell.course == course && at.op == Op::knit) knits.push_back(&at);
    return knits;
  }

  bool round() const { return chart_.form == Form::tube; }

  static Direction turned(Direction direction) {
    return direction == Direction::increasing ? Direction::decreasing : Direction::increasing;
  }

  Instruction& add(Op op, const Needle& needle = {}) {
    Instruction& made = made_.code.emplace_back();
    made.op = op;
    made.needle = needle;
    return made;
  }

  void add(const Instruction& at) {
    if (brings_in(at.op) || takes_out(at.op) || at.cell.course > hook_course_) release_hook();
    set_size(at.stitch_length);
    Instruction& made = made_.code.emplace_back(at);
    if (!target_.hook || !(brings_in(at.op) || takes_out(at.op))) return;
    made.op = brings_in(at.op) ? Op::inhook : Op::outhook;
    if (made.op == Op::outhook) return;
    hook_ = at.carriers;
    hook_course_ = at.cell.course;
  }

  void release_hook() {
    if (!hook_.empty()) add(Op::releasehook).carriers = std::exchange(hook_, {});
  }

  /// The size whose loop is nearest to the chart's, on machines where numbers are sizes.
  void set_size(double length) {
    if (sizes_.by_setting.empty() || length <= 0) return;
    const auto error = [&](char size) { return std::abs(sizes_.at(std::string_view(&size, 1)) - length); };
    const char size = *std::min_element(stitch_sizes.begin(), stitch_sizes.end(),
                                        [&](char a, char b) { return error(a) < error(b); });
    if (std::exchange(size_, size) == size) return;
    const int index = static_cast<int>(made_.extensions.size());
    made_.extensions.push_back(fmt::format("x-stitch-number {}", size));
    add(Op::extension).extension = index;
  }

  void stitch(Op op, const Needle& needle, Direction direction, int carrier) {
    Instruction& made = add(op, needle);
    made.direction = direction;
    made.carriers = {carrier};
  }

  /// Tucks every other needle on the way there and the rest on the way back; round a tube, the rest in a second round.
  void cast_on() {
    const Knits first = knits_of(0);
    const int carrier = first.front()->carriers.front();
    set_size(first.front()->stitch_length);
    for (std::size_t i = 0; i < first.size(); i += 2) stitch(Op::tuck, tucked(*first[i]), first[i]->direction, carrier);
    for (std::size_t k = 1; k < first.size(); k += 2) {
      const std::size_t last_odd = first.size() - (first.size() % 2 == 0 ? 1 : 2);
      const Instruction& at = *first[round() ? k : last_odd + 1 - k];
      stitch(Op::tuck, tucked(at), round() ? at.direction : turned(at.direction), carrier);
    }
  }

  /// Where the cast-on tucks for a loop of the first course: a tube's loops must wait on their half's own bed.
  Needle tucked(const Instruction& at) const { return round() ? home(at) : at.needle; }

  /// And from there it goes to where it is knitted.
  void hang_over(const Instruction& at) {
    if (chart_.start == Edge::cast_on && at.op == Op::knit && at.cell.course == 0 && tucked(at) != at.needle)
      transfer(tucked(at), at.needle);
  }

  void transfer(const Needle& from, const Needle& to) { add(Op::split, from).other = to; }

  void rack(int needles) { add(Op::rack).value[0] = needles; }

  /// To a neighbour: across the beds at once, or by way of the needle that faces it.
  void transfer_along(Needle from, const Needle& to) {
    if (from.bed == to.bed) {
      const Needle across{on_back(from) ? Bed::front : Bed::back, from.index};
      transfer(from, across);
      from = across;
    }
    rack(on_back(from) ? to.index - from.index : from.index - to.index);
    transfer(from, to);
    rack(0);
  }

  /// From where the last course ends, each loop goes to the next needle and is knitted together with the loop there.
  /// The last one stays on its needle until somebody draws the yarn's end through it: dropped, it would all run.
  void bind_off() {
    Knits last = knits_of(chart_.course_count() - 1);
    const int carrier = last.back()->carriers.front();
    if (!round()) std::reverse(last.begin(), last.end());
    for (const Instruction* at : last)
      if (!round() && home(*at) != at->needle) transfer(at->needle, home(*at));
    for (std::size_t i = 0; i < last.size(); ++i) {
      if (i > 0) transfer_along(home(*last[i - 1]), home(*last[i]));
      stitch(Op::knit, home(*last[i]), round() ? last[i]->direction : turned(last[i]->direction), carrier);
    }
  }

  /// Where a loop lies as a knit: on the front bed, or on the back bed for the back of a tube.
  Needle home(const Instruction& at) const {
    const bool behind = round() && at.cell.wale >= chart_.wales() / 2;
    return {behind ? Bed::back : Bed::front, at.needle.index};
  }

  const Chart& chart_;
  const Program& lowered_;
  const Target& target_;
  Program made_;
  StitchLengths sizes_;    // empty if the machine's numbers say nothing
  char size_ = 0;          // in force
  std::vector<int> hook_;  // carriers that the inserting hook holds
  int hook_course_ = 0;    // when they came in
};

}  // namespace

std::optional<Program> machine_program(const Chart& chart, const Target& target, Diagnostics& say) {
  const auto lowered = lower_chart(chart, say);
  if (!lowered) return {};
  if (static_cast<int>(chart.yarns.size()) > target.carriers) {
    say.error(codes::too_many_yarns, chart.span,
              fmt::format("the chart has {} yarns, but a {} {} carriers", chart.yarns.size(), target.machine,
                          target.carriers),
              "knit with fewer yarns");
    return {};
  }
  return Dressing(chart, *lowered, target).run();
}

}  // namespace wale::passes
