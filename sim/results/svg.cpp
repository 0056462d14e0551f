#include "sim/results/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wale::svg {

std::string escape(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t')
      escaped += c;  // XML has no other control characters
  }
  return escaped;
}

std::string text(double x, double y, std::string_view anchor, std::string_view words, std::string_view attributes) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y, anchor, attributes,
                     escape(words));
}

std::string open(double width, double height) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"15\" fill=\"#222\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      width, height);
}

double round_below(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= most) return factor * power;
  return power;
}

std::vector<double> ticks(double low, double high, int most) {
  std::vector<double> found;
  if (!(high > low)) return found;
  double step = round_below((high - low) / most);
  while ((high - low) / step > most) step = round_below(2.6 * step);
  for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) found.push_back(i * step);
  return found;
}

std::string hex(const Colour& colour) { return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]); }

Colour gradient(double value) {
  constexpr std::array<Colour, 6> knots{
      {{62, 38, 110}, {52, 86, 150}, {31, 136, 148}, {62, 178, 116}, {160, 210, 60}, {250, 226, 50}}};
  const double at = std::clamp(value, 0.0, 1.0) * (knots.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(at), knots.size() - 2);
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = static_cast<int>(
        std::lround(knots[below][i] + (at - static_cast<double>(below)) * (knots[below + 1][i] - knots[below][i])));
  return colour;
}

Colour palette(int index) {
  constexpr std::array<Colour, 6> colours{
      {{201, 94, 72}, {62, 126, 166}, {226, 178, 66}, {94, 138, 92}, {146, 104, 146}, {208, 190, 164}}};
  return colours[static_cast<std::size_t>(index) % colours.size()];
}

}  // namespace wale::svg
