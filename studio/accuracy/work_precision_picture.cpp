#include "studio/accuracy/work_precision_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/results/svg.hpp"

namespace wale {
namespace {

constexpr double width = 980, height = 560, left = 92, right = 250, top = 48, bottom = 62;  // px

/// The decades that the axes show, as powers of ten.
struct Range {
  double time_low = 1e9, time_high = -1e9, error_low = 1e9, error_high = -1e9;

  void include(const WorkPrecision& at) {
    time_low = std::min(time_low, std::log10(at.seconds));
    time_high = std::max(time_high, std::log10(at.seconds));
    error_low = std::min(error_low, std::log10(at.error));
    error_high = std::max(error_high, std::log10(at.error));
  }
  void widen() {
    constexpr double margin = 0.08;
    time_low -= margin;
    time_high += margin;
    error_low -= margin;
    error_high += margin;
  }
  double x(double seconds) const {
    return left + (width - left - right) * (std::log10(seconds) - time_low) / (time_high - time_low);
  }
  double y(double error) const {
    return height - bottom - (height - top - bottom) * (std::log10(error) - error_low) / (error_high - error_low);
  }
};

bool is_drawn(const WorkPrecisionMark& mark) {
  return std::isfinite(mark.at.error) && mark.at.error > 0 && mark.at.seconds > 0;
}

/// 1, 2 and 5 times the powers of ten within, given as powers.
std::vector<double> round_numbers(double low, double high) {
  std::vector<double> found;
  for (double power = std::floor(low); power <= high; ++power)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * std::pow(10, power);
      if (std::log10(value) >= low && std::log10(value) <= high) found.push_back(value);
    }
  return found;
}

std::string axes(const Range& range) {
  std::string svg = "<g stroke=\"#e4e4e4\">\n", labels;
  for (const double seconds : round_numbers(range.time_low, range.time_high)) {
    svg += fmt::format("<path d=\"M{:.1f} {}V{}\"/>\n", range.x(seconds), top, height - bottom);
    labels += svg::text(range.x(seconds), height - bottom + 22, "middle", fmt::format("{:g}", seconds));
  }
  for (const double error : round_numbers(range.error_low, range.error_high)) {
    svg += fmt::format("<path d=\"M{} {:.1f}H{}\"/>\n", left, range.y(error), width - right);
    labels += svg::text(left - 10, range.y(error) + 5, "end", fmt::format("{:g} %", 100 * error));
  }
  const double middle = (top + height - bottom) / 2;
  return svg + "</g>\n" + labels +
         fmt::format("<path fill=\"none\" stroke=\"#222\" d=\"M{} {}V{}H{}\"/>\n", left, top, height - bottom,
                     width - right) +
         svg::text((left + width - right) / 2, height - 16, "middle", "processor time, s") +
         svg::text(20, middle, "middle", "error", fmt::format("transform=\"rotate(-90 20 {:.1f})\"", middle));
}

std::string front(const std::vector<WorkPrecisionLine>& lines, const Range& range) {
  std::vector<WorkPrecision> all;
  for (const WorkPrecisionLine& line : lines)
    for (const WorkPrecisionMark& mark : line.marks)
      if (is_drawn(mark) && !mark.hollow) all.push_back(mark.at);
  std::string points;
  for (const std::size_t i : pareto_front(all))
    points += fmt::format("{:.1f},{:.1f} ", range.x(all[i].seconds), range.y(all[i].error));
  return fmt::format(
      "<polyline fill=\"none\" stroke=\"#d9d9d9\" stroke-width=\"14\" stroke-linejoin=\"round\" "
      "stroke-linecap=\"round\" points=\"{}\"/>\n",
      points);
}

std::string drawn(const WorkPrecisionLine& line, const Range& range, int index) {
  const std::string colour = svg::hex(svg::palette(index));
  std::string points, marks;
  for (const WorkPrecisionMark& mark : line.marks) {
    if (!is_drawn(mark)) continue;
    const double x = range.x(mark.at.seconds), y = range.y(mark.at.error);
    if (!mark.hollow) points += fmt::format("{:.1f},{:.1f} ", x, y);
    marks += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\" fill=\"{}\" stroke=\"{}\"><title>{}</title></circle>\n", x, y,
        mark.hollow ? "#fff" : colour, colour,
        svg::escape(
            fmt::format("{} {}: {:.3g} %, {:.3g} s", line.label, mark.label, 100 * mark.at.error, mark.at.seconds)));
  }
  // The palette repeats after six colours, so that later lines are broken ones.
  const char* dashes = index < 6 ? "" : " stroke-dasharray=\"7 4\"";
  if (line.joined)
    marks = fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{} points=\"{}\"/>\n", colour, dashes,
                        points) +
            marks;
  const double y = top + 12 + 24 * index, key = width - right + 22;
  return marks +
         fmt::format("<path stroke=\"{}\" stroke-width=\"3\"{} d=\"M{} {:.1f}h26\"/>\n", colour,
                     line.joined ? dashes : " stroke-dasharray=\"3 8\"", key, y) +
         svg::text(key + 36, y + 5, "start", line.label);
}

}  // namespace

std::string work_precision_svg(const std::vector<WorkPrecisionLine>& lines, const std::string& title) {
  Range range;
  for (const WorkPrecisionLine& line : lines)
    for (const WorkPrecisionMark& mark : line.marks)
      if (is_drawn(mark)) range.include(mark.at);
  if (range.time_low > range.time_high) return "";
  range.widen();
  std::string svg = svg::open(width, height) + axes(range) + front(lines, range);
  svg += svg::text(left, 28, "start", title, "font-size=\"18\" font-weight=\"bold\"");
  for (std::size_t i = 0; i < lines.size(); ++i) svg += drawn(lines[i], range, static_cast<int>(i));
  const double y = top + 12 + 24 * static_cast<double>(lines.size()), key = width - right + 22;
  svg += fmt::format("<path stroke=\"#d9d9d9\" stroke-width=\"14\" stroke-linecap=\"round\" d=\"M{} {:.1f}h20\"/>\n",
                     key + 3, y);
  return svg + svg::text(key + 36, y + 5, "start", "Pareto front") + "</svg>\n";
}

}  // namespace wale
