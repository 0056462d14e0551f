#include <fmt/format.h>

#include <vector>

#include "compiler/passes.hpp"
#include "compiler/passes/program_codes.hpp"

namespace wale::passes {
namespace {

bool in_back_half(const Chart& chart, int wale) { return chart.form == Form::tube && wale >= chart.wales() / 2; }

/// A flat fabric uses every needle. A tube lies folded over both beds at half gauge: its front half on even needles,
/// its back half on odd ones, so that the needle across from a loop is free to take it.
int needle_index(const Chart& chart, int wale) {
  if (chart.form == Form::flat) return wale;
  return in_back_half(chart, wale) ? 2 * (chart.wales() - 1 - wale) + 1 : 2 * wale;
}

/// The front bed shows a knit to the front; the back half of a tube shows its outside to the back.
Needle needle_of(const Chart& chart, int wale, Stitch stitch) {
  const bool front = (stitch == Stitch::knit) != in_back_half(chart, wale);
  return {front ? Bed::front : Bed::back, needle_index(chart, wale)};
}

Direction along(const Chart& chart, int wale, bool from_left) {
  return from_left != in_back_half(chart, wale) ? Direction::increasing : Direction::decreasing;
}

bool starts_from_left(const Chart& chart, int course) {
  if (chart.periodic) return true;
  const bool first = chart.first_course_from == Side::left;
  return chart.form == Form::tube || course % 2 == 0 ? first : !first;
}

class Lowering {
 public:
  explicit Lowering(const Chart& chart) : chart_(chart), stitches_left_(chart.yarns.size(), 0) {
    for (const ChartYarn& yarn : chart.yarns) program_.carriers.push_back(yarn.name);
    for (const auto& course : chart.courses)
      for (const Cell& cell : course) ++stitches_left_[static_cast<std::size_t>(cell.yarn)];
    in_.assign(chart.yarns.size(), false);
  }

  Program run() {
    for (int course = 0; course < chart_.course_count(); ++course) {
      if (chart_.form == Form::tube) {
        knit_round(course);
      } else {
        if (course > 0) transfer_to(course);
        knit_row(course);
        if (chart_.periodic) end_course(course);
      }
    }
    return std::move(program_);
  }

 private:
  const Cell& cell_at(int course, int wale) const {
    return chart_.courses[static_cast<std::size_t>(course)][static_cast<std::size_t>(wale)];
  }

  Instruction& emit(Op op, int course, int wale) {
    Instruction& made = program_.code.emplace_back();
    made.op = op;
    made.cell = {course, wale};
    made.span = cell_at(course, wale).span;
    return made;
  }

  void transfer(int course, int wale, Stitch from, Stitch to) {
    if (from == to) return;
    Instruction& transfer = emit(Op::split, course, wale);
    transfer.needle = needle_of(chart_, wale, from);
    transfer.other = needle_of(chart_, wale, to);
  }

  void transfer_to(int course) {
    for (int wale = 0; wale < chart_.wales(); ++wale)
      transfer(course, wale, cell_at(course - 1, wale).stitch, cell_at(course, wale).stitch);
  }

  void knit_row(int course) {
    const bool from_left = starts_from_left(chart_, course);
    for (int i = 0; i < chart_.wales(); ++i) {
      stitch(course, from_left ? i : chart_.wales() - 1 - i, from_left);
      take_out();
    }
  }

  /// The yarn goes on to the right; what comes in from the left in the next course is another piece of it.
  void end_course(int course) {
    const ChartCell last{course, chart_.wales() - 1};
    if (in_[static_cast<std::size_t>(cell_at(last.course, last.wale).yarn)]) take_out(last);
  }

  /// Half by half. Loops wait on their half's own bed, the front half's on the front bed: on the other they would lie
  /// behind the yarn that knits the other half, and the halves would be knitted into each other.
  void knit_round(int course) {
    const bool from_left = starts_from_left(chart_, course);
    const int half = chart_.wales() / 2;
    for (const bool back : {!from_left, from_left}) {
      const int first = back ? half : 0;
      for (int wale = first; course > 0 && wale < first + half; ++wale)
        transfer(course, wale, Stitch::knit, cell_at(course, wale).stitch);
      for (int i = 0; i < half; ++i) stitch(course, first + (from_left ? i : half - 1 - i), from_left);
      for (int wale = first; wale < first + half; ++wale)
        transfer(course, wale, cell_at(course, wale).stitch, Stitch::knit);
      take_out();
    }
  }

  void stitch(int course, int wale, bool from_left) {
    const Cell& cell = cell_at(course, wale);
    const auto yarn = static_cast<std::size_t>(cell.yarn);
    if (!in_[yarn]) emit(Op::in, course, wale).carriers = {cell.yarn};
    in_[yarn] = true;
    Instruction& made = emit(Op::knit, course, wale);
    made.direction = along(chart_, wale, from_left);
    made.needle = needle_of(chart_, wale, cell.stitch);
    made.carriers = {cell.yarn};
    made.stitch_length = cell.stitch_length;
    if (--stitches_left_[yarn] == 0) done_.push_back({course, wale});
  }

  /// The yarns whose last stitch is made.
  void take_out() {
    for (const ChartCell& at : done_) take_out(at);
    done_.clear();
  }

  void take_out(const ChartCell& at) {
    const int yarn = cell_at(at.course, at.wale).yarn;
    emit(Op::out, at.course, at.wale).carriers = {yarn};
    in_[static_cast<std::size_t>(yarn)] = false;
  }

  const Chart& chart_;
  Program program_;
  std::vector<long> stitches_left_;  // by yarn
  std::vector<bool> in_;
  std::vector<ChartCell> done_;  // the last stitches of yarns that have not been taken out
};

}  // namespace

std::optional<Program> lower_chart(const Chart& chart, Diagnostics& say) {
  if (chart.wales() == 0) {
    say.error(codes::empty_chart, chart.span, "the chart has no stitches", "give it at least one course and one wale");
    return {};
  }
  if (chart.form == Form::tube && (chart.wales() % 2 != 0 || chart.wales() < 4)) {
    say.error(codes::tube_wales, chart.span,
              fmt::format("a tube of {} wales cannot be laid over two beds", chart.wales()),
              "use an even number of wales, at least 4");
    return {};
  }
  return Lowering(chart).run();
}

}  // namespace wale::passes
