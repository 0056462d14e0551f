#include <fmt/format.h>

#include <algorithm>

#include "compiler/passes.hpp"

namespace wale::passes {
namespace {

/// So far from every edge a fabric is as in its middle.
constexpr int margin = 6;

/// The first stitch of another yarn than the one before it in its course; null if there is none.
const Cell* change_of_yarn(const std::vector<Cell>& course) {
  const auto at = std::adjacent_find(course.begin(), course.end(),
                                     [](const Cell& one, const Cell& next) { return one.yarn != next.yarn; });
  return at == course.end() ? nullptr : &*(at + 1);
}

const Cell* change_of_yarn(const Chart& chart) {
  for (const std::vector<Cell>& course : chart.courses)
    if (const Cell* at = change_of_yarn(course)) return at;
  return nullptr;
}

bool can_go_on(const Chart& chart, Diagnostics& say) {
  if (chart.form == Form::tube) {
    say.error("C014", chart.span, "a tube cannot be continued to its sides: it has none",
              "write `form: flat` in the chart, or leave `periodic` out of the scene");
    return false;
  }
  if (const Cell* at = change_of_yarn(chart)) {
    say.error("C014", at->span,
              fmt::format("yarn \"{}\" begins inside a course, but in a periodic fabric every yarn goes right across",
                          chart.yarns[static_cast<std::size_t>(at->yarn)].name),
              "knit each course with one yarn, as in stripes, or leave `periodic` out of the scene");
    return false;
  }
  return true;
}

/// The cells `margin` before the first, those of the repeat, and `margin` after the last.
template <class T>
std::vector<T> continued(const std::vector<T>& repeat) {
  const auto count = static_cast<int>(repeat.size());
  std::vector<T> all;
  for (int k = -margin; k < count + margin; ++k)
    all.push_back(repeat[static_cast<std::size_t>((k % count + count) % count)]);
  return all;
}

}  // namespace

std::optional<Continued> continue_chart(const Chart& chart, Diagnostics& say) {
  if (chart.wales() == 0) return Continued{chart, {}};  // lower_chart reports it
  if (!can_go_on(chart, say)) return std::nullopt;
  Chart larger = chart;
  larger.start = larger.end = Edge::open;
  larger.courses = continued(chart.courses);
  for (std::vector<Cell>& course : larger.courses) course = continued(course);
  return Continued{std::move(larger), {chart.wales(), chart.course_count(), margin}};
}

}  // namespace wale::passes
