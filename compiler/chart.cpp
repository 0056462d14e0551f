#include "compiler/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace wale {
namespace {

/// One character a yarn: its name if that is one character, else the next free letter.
std::vector<std::string> yarn_letters(const std::vector<ChartYarn>& yarns) {
  std::set<std::string> taken;
  for (const ChartYarn& yarn : yarns) {
    if (yarn.name.size() == 1) taken.insert(yarn.name);
  }
  std::vector<std::string> letters;
  char next = 'a';
  for (const ChartYarn& yarn : yarns) {
    if (yarn.name.size() == 1) {
      letters.push_back(yarn.name);
      continue;
    }
    while (next <= 'z' && taken.contains(std::string(1, next))) ++next;
    letters.push_back(next <= 'z' ? std::string(1, next++) : "?");
  }
  return letters;
}

/// ` 7.23 mm` if all stitches of the course are equally long.
std::string stitch_lengths(const std::vector<Cell>& course) {
  const auto [least, most] = std::minmax_element(
      course.begin(), course.end(), [](const Cell& a, const Cell& b) { return a.stitch_length < b.stitch_length; });
  if (most->stitch_length - least->stitch_length < 1e-9) return fmt::format("{:g} mm", least->stitch_length * 1e3);
  return fmt::format("{:g} to {:g} mm", least->stitch_length * 1e3, most->stitch_length * 1e3);
}

std::string print_course(const Chart& chart, int number, const std::vector<std::string>& letters) {
  const std::vector<Cell>& course = chart.courses[static_cast<std::size_t>(number)];
  std::string stitches, yarns;
  for (const Cell& cell : course) {
    stitches += cell.stitch == Stitch::knit ? 'k' : 'p';
    yarns += letters[static_cast<std::size_t>(cell.yarn)];
  }
  const bool turns = chart.form == Form::flat && number % 2 == 1;
  const bool from_right = (chart.first_course_from == Side::right) != turns;
  return fmt::format("{:>5} {} {}  {}  {}\n", number + 1, from_right ? "<-" : "->", stitches, yarns,
                     stitch_lengths(course));
}

}  // namespace

std::string print(const Chart& chart) {
  const std::vector<std::string> letters = yarn_letters(chart.yarns);
  std::string text =
      fmt::format("{}: {}, {} wales x {} courses, {} to {}\n", chart.name,
                  chart.form == Form::flat ? "flat" : "tube, seen from outside", chart.wales(), chart.course_count(),
                  chart.start == Edge::cast_on ? "cast on" : "open", chart.end == Edge::bind_off ? "bind off" : "open");
  for (std::size_t i = 0; i < chart.yarns.size(); ++i) {
    const ChartYarn& yarn = chart.yarns[i];
    text += fmt::format("yarn {} = {}: {}, contact diameter {:g} mm, {:g} tex\n", letters[i], yarn.name,
                        yarn.material.name, yarn.material.diameter * 1e3, yarn.material.linear_density * 1e6);
  }
  for (int number = chart.course_count() - 1; number >= 0; --number) text += print_course(chart, number, letters);
  return text;
}

}  // namespace wale
