#include <fmt/format.h>

#include <vector>

#include "compiler/passes.hpp"
#include "compiler/passes/program_codes.hpp"

namespace wale::passes {
namespace {

/// Fills the cells of a chart with loops; stops at the first loop that does not fit.
class Placing {
 public:
  Placing(const StitchGraph& graph, const Chart& chart, Diagnostics& say) : graph_(graph), chart_(chart), say_(say) {
    layout_.form = chart.form;
    layout_.wales = chart.wales();
    layout_.courses = chart.course_count();
    layout_.cast_on = chart.start == Edge::cast_on;
    layout_.bind_off = chart.end == Edge::bind_off;
    PlacedLoop nothing;
    nothing.loop = -1;
    const std::vector<PlacedLoop> row(static_cast<std::size_t>(layout_.wales), nothing);
    layout_.rows.assign(static_cast<std::size_t>(layout_.courses), row);
  }

  std::optional<Layout> run() {
    for (int i = 0; i < static_cast<int>(graph_.loops.size()); ++i)
      if (!put(i)) return {};
    if (!all_filled() || !in_order()) return {};
    look_up();
    return std::move(layout_);
  }

 private:
  PlacedLoop& at(int course, int wale) {
    return layout_.rows[static_cast<std::size_t>(course)][static_cast<std::size_t>(wale)];
  }
  const Loop& loop(int i) const { return graph_.loops[static_cast<std::size_t>(i)]; }

  bool refuse(Span span, std::string why) {
    say_.error(codes::not_placeable, span, std::move(why) + ", which cannot be placed yet",
               "knit every cell of the chart, each through the loop below it");
    return false;
  }

  bool put(int i) {
    const Loop& of = loop(i);
    const auto [course, wale] = of.cell;
    if (course < 0 || wale < 0 || course >= layout_.courses || wale >= layout_.wales)
      return refuse(of.span, fmt::format("loop {} belongs to no cell of the chart", i));
    PlacedLoop& place = at(course, wale);
    if (place.loop >= 0) return refuse(of.span, fmt::format("loops {} and {} belong to one cell", place.loop, i));
    if (of.kind != LoopKind::knit) return refuse(of.span, fmt::format("loop {} is a tuck", i));
    if (!fits_below(of)) {
      const std::string below = course > 0 ? "exactly the loop below" : "nothing, in the first course";
      return refuse(of.span, fmt::format("loop {} is not pulled through {}", i, below));
    }
    place = {i, course, wale, sign_of(of), 1, of.carrier, of.stitch_length};
    return true;
  }

  bool fits_below(const Loop& of) {
    if (of.cell.course == 0) return of.through.empty();
    const int below = at(of.cell.course - 1, of.cell.wale).loop;
    return of.through.size() == 1 && of.through.front() == below;
  }

  /// The back half of a tube shows its outside to the back, so that there the back bed makes a knit.
  int sign_of(const Loop& of) const {
    const bool turned = layout_.form == Form::tube && of.cell.wale >= layout_.wales / 2;
    return (of.needle.bed == Bed::front) != turned ? 1 : -1;
  }

  bool all_filled() {
    for (int course = 0; course < layout_.courses; ++course)
      for (int wale = 0; wale < layout_.wales; ++wale)
        if (at(course, wale).loop < 0) {
          const auto& row = chart_.courses[static_cast<std::size_t>(course)];
          return refuse(row[static_cast<std::size_t>(wale)].span,
                        fmt::format("no loop is knit for course {}, wale {}", course + 1, wale + 1));
        }
    return true;
  }

  /// A course is knitted one way; loops are numbered as they are made.
  bool in_order() {
    for (int course = 0; course < layout_.courses; ++course) {
      const bool from_left = starts_left(course);
      for (int wale = 1; wale < layout_.wales; ++wale) {
        const int made = at(course, wale).loop;
        if ((made > at(course, wale - 1).loop) != from_left)
          return refuse(loop(made).span, fmt::format("loop {} is out of order in its course", made));
      }
      layout_.from_left.push_back(from_left ? 1 : 0);
    }
    return true;
  }

  bool starts_left(int course) {
    if (layout_.wales > 1) return at(course, 0).loop < at(course, 1).loop;
    return loop(at(course, 0).loop).direction != Direction::decreasing;
  }

  void look_up() {
    for (int course = 0; course < layout_.courses; ++course)
      for (int wale = 0; wale < layout_.wales; ++wale)
        at(course, wale).sign_above = at(course + 1 < layout_.courses ? course + 1 : course, wale).sign;
  }

  const StitchGraph& graph_;
  const Chart& chart_;
  Diagnostics& say_;
  Layout layout_;
};

}  // namespace

std::optional<Layout> place(const StitchGraph& graph, const Chart& chart, Diagnostics& say) {
  return Placing(graph, chart, say).run();
}

}  // namespace wale::passes
