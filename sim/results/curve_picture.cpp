#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/results/picture.hpp"
#include "sim/results/svg.hpp"

namespace wale {
namespace {

constexpr double width = 760, height = 480;
constexpr double left = 84, right = 24, top = 44, bottom = 62;  // px, around the axes

/// The ranges of strain, %, and of stress, MPa.
struct Range {
  double strain_low = 0, strain_high = 0, stress_low = 0, stress_high = 0;
  double x(double strain) const {
    return left + (width - left - right) * (strain - strain_low) / (strain_high - strain_low);
  }
  double y(double stress) const {
    return height - bottom - (height - top - bottom) * (stress - stress_low) / (stress_high - stress_low);
  }
};

struct Place {
  double strain = 0, stress = 0;  // %, MPa
};

std::vector<Place> places(const Curve& curve) {
  std::vector<Place> found;
  for (std::size_t i = 0; i < curve.strain.size(); ++i)
    if (std::isfinite(curve.strain[i]) && std::isfinite(curve.stress[i]))
      found.push_back({100 * curve.strain[i], 1e-6 * curve.stress[i]});
  return found;
}

Range range_of(const std::vector<std::vector<Place>>& curves) {
  Range range;
  for (const std::vector<Place>& curve : curves)
    for (const Place& at : curve) {
      range.strain_low = std::min(range.strain_low, at.strain);
      range.strain_high = std::max(range.strain_high, at.strain);
      range.stress_low = std::min(range.stress_low, at.stress);
      range.stress_high = std::max(range.stress_high, at.stress);
    }
  if (range.strain_high == range.strain_low) range.strain_high += 1;
  if (range.stress_high == range.stress_low) range.stress_high += 1;
  range.stress_high += 0.05 * (range.stress_high - range.stress_low);
  return range;
}

/// A number on an axis: as short as can be, and zero without a sign.
std::string number(double value, double span) {
  return fmt::format("{:.6g}", std::abs(value) < 1e-9 * span ? 0.0 : value);
}

std::string axes(const Range& range) {
  std::string svg = "<g stroke=\"#ddd\">\n", labels;
  for (const double strain : svg::ticks(range.strain_low, range.strain_high, 8)) {
    svg += fmt::format("<path d=\"M{:.1f} {}V{}\"/>\n", range.x(strain), top, height - bottom);
    labels += svg::text(range.x(strain), height - bottom + 22, "middle",
                        number(strain, range.strain_high - range.strain_low));
  }
  for (const double stress : svg::ticks(range.stress_low, range.stress_high, 8)) {
    svg += fmt::format("<path d=\"M{} {:.1f}H{}\"/>\n", left, range.y(stress), width - right);
    labels += svg::text(left - 10, range.y(stress) + 5, "end", number(stress, range.stress_high - range.stress_low));
  }
  svg += "</g>\n" + labels;
  svg += fmt::format("<path fill=\"none\" stroke=\"#222\" d=\"M{} {}V{}H{}\"/>\n", left, top, height - bottom,
                     width - right);
  svg += svg::text((left + width - right) / 2, height - 16, "middle", "strain, %");
  const double middle = (top + height - bottom) / 2;
  return svg +
         svg::text(22, middle, "middle", "stress, MPa", fmt::format("transform=\"rotate(-90 22 {:.1f})\"", middle));
}

std::string line(const std::vector<Place>& curve, const Range& range, int index) {
  const std::string colour = svg::hex(svg::palette(index));
  std::string points, marks;
  for (const Place& at : curve) {
    points += fmt::format("{:.1f},{:.1f} ", range.x(at.strain), range.y(at.stress));
    if (curve.size() <= 80)
      marks += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", range.x(at.strain),
                           range.y(at.stress), colour);
  }
  return fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"2.2\" points=\"{}\"/>\n", colour, points) +
         marks;
}

}  // namespace

std::string curve_svg(const std::vector<LabelledCurve>& curves, const std::string& title) {
  std::vector<std::vector<Place>> lines;
  for (const LabelledCurve& each : curves) lines.push_back(places(each.curve));
  const Range range = range_of(lines);
  std::string svg = svg::open(width, height) + axes(range);
  if (!title.empty()) svg += svg::text(left, 28, "start", title, "font-size=\"18\" font-weight=\"bold\"");
  for (std::size_t i = 0; i < curves.size(); ++i) {
    svg += line(lines[i], range, static_cast<int>(i));
    if (curves[i].label.empty()) continue;
    const double y = top + 20 + 22 * static_cast<double>(i);
    svg += fmt::format("<path stroke=\"{}\" stroke-width=\"3\" d=\"M{} {:.1f}h24\"/>\n",
                       svg::hex(svg::palette(static_cast<int>(i))), left + 16, y);
    svg += svg::text(left + 48, y + 5, "start", curves[i].label);
  }
  return svg + "</svg>\n";
}

}  // namespace wale
