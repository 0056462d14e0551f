/// Charts drawn by hand, for tests that do not want the YAML front.
#pragma once

#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "compiler/chart.hpp"

namespace wale {

/// One line a course, the last line the first course; `k` and `p` as seen from the face. One yarn `a` of the default
/// material, 7.23 mm a stitch. Spans count the characters of the picture, a line end after each line; no source.
inline Chart make_chart(const std::vector<std::string>& picture, Form form = Form::flat) {
  Chart chart;
  chart.name = "test";
  chart.form = form;
  chart.yarns.push_back({"a", Material{}, "#c9b79c"});
  std::uint32_t begin = 0;
  for (const std::string& line : picture) {
    std::vector<Cell> course;
    for (const char symbol : line) {
      if (symbol != 'k' && symbol != 'p') throw std::invalid_argument("make_chart: a picture holds k and p");
      course.push_back({symbol == 'k' ? Stitch::knit : Stitch::purl, 0, 7.23e-3, {nullptr, begin, begin + 1}});
      ++begin;
    }
    ++begin;
    chart.courses.insert(chart.courses.begin(), std::move(course));
  }
  return chart;
}

/// Knit and purl by the toss of a coin; the same chart for the same seed.
inline Chart make_random_chart(int wales, int courses, Form form, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::string> picture(static_cast<std::size_t>(courses));
  for (std::string& line : picture)
    for (int i = 0; i < wales; ++i) line += random() % 2 ? 'k' : 'p';
  return make_chart(picture, form);
}

}  // namespace wale
