#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/results/picture.hpp"

namespace wale {
namespace {

constexpr int columns = 60, rows = 15;  // characters
constexpr int dots_x = 2 * columns, dots_y = 4 * rows;

/// A character of Braille has 2 x 4 dots, numbered down the columns, the lowest two last.
class Canvas {
 public:
  void dot(int x, int y) {
    constexpr std::array<std::array<unsigned, 4>, 2> bits{{{0x01, 0x02, 0x04, 0x40}, {0x08, 0x10, 0x20, 0x80}}};
    if (x < 0 || x >= dots_x || y < 0 || y >= dots_y) return;
    cells_[static_cast<std::size_t>(y / 4 * columns + x / 2)] |=
        bits[static_cast<std::size_t>(x % 2)][static_cast<std::size_t>(y % 4)];
  }
  void line(double x0, double y0, double x1, double y1) {
    const int steps = std::max(1, static_cast<int>(std::ceil(2 * std::max(std::abs(x1 - x0), std::abs(y1 - y0)))));
    for (int i = 0; i <= steps; ++i)
      dot(static_cast<int>(std::lround(x0 + (x1 - x0) * i / steps)),
          static_cast<int>(std::lround(y0 + (y1 - y0) * i / steps)));
  }
  std::string row(int y) const {
    std::string text;
    for (int x = 0; x < columns; ++x) {
      const unsigned code = 0x2800 + cells_[static_cast<std::size_t>(y * columns + x)];
      text += static_cast<char>(0xE0 | (code >> 12));
      text += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
      text += static_cast<char>(0x80 | (code & 0x3F));
    }
    return text;
  }

 private:
  std::array<unsigned, columns * rows> cells_{};
};

}  // namespace

std::string terminal_plot(const Curve& curve) {
  std::vector<std::array<double, 2>> points;
  for (std::size_t i = 0; i < curve.strain.size(); ++i)
    if (std::isfinite(curve.strain[i]) && std::isfinite(curve.stress[i]))
      points.push_back({100 * curve.strain[i], 1e-6 * curve.stress[i]});
  if (points.empty()) return "no curve\n";
  double strain_low = 0, strain_high = 0, stress_low = 0, stress_high = 0;
  for (const auto& [strain, stress] : points) {
    strain_low = std::min(strain_low, strain), strain_high = std::max(strain_high, strain);
    stress_low = std::min(stress_low, stress), stress_high = std::max(stress_high, stress);
  }
  if (strain_high == strain_low) strain_high = strain_low + 1;
  if (stress_high == stress_low) stress_high = stress_low + 1;
  const auto x = [&](double strain) { return (dots_x - 1) * (strain - strain_low) / (strain_high - strain_low); };
  const auto y = [&](double stress) { return (dots_y - 1) * (stress_high - stress) / (stress_high - stress_low); };
  Canvas canvas;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [strain, stress] = points[i];
    const auto& [before, stress_before] = points[i == 0 ? 0 : i - 1];
    canvas.line(x(before), y(stress_before), x(strain), y(stress));
  }
  std::string text = fmt::format("{:>10}\n", "MPa");
  for (int row = 0; row < rows; ++row) {
    const bool is_labelled = row % 7 == 0;  // top, middle and bottom
    const double value = stress_high - (stress_high - stress_low) * row / (rows - 1);
    text += is_labelled ? fmt::format("{:>10.3g} ┤", value) : fmt::format("{:>10} │", "");
    text += canvas.row(row) + "\n";
  }
  text += fmt::format("{:>10} └", "");
  for (int i = 0; i < columns; ++i) text += "─";
  const std::string high = fmt::format("{:.3g} %", strain_high);
  return text + fmt::format("\n{:>12}{:<{}}{}\n", "", fmt::format("{:.3g}", strain_low),
                            columns - static_cast<int>(high.size()), high);
}

}  // namespace wale
