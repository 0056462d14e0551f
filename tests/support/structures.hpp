/// Charts of every kind that geometry must hold for: the named structures, their mixtures, flat and round.
#pragma once

#include <functional>

#include "tests/support/make_chart.hpp"

namespace wale {

struct NamedChart {
  std::string name;
  Chart chart;
};

/// `face(course, wale)` says whether a stitch is a knit; courses count from the first knitted.
inline Chart make_chart_of(int wales, int courses, Form form, const std::function<bool(int, int)>& face) {
  std::vector<std::string> picture;
  for (int course = courses - 1; course >= 0; --course) {
    std::string line;
    for (int wale = 0; wale < wales; ++wale) line += face(course, wale) ? 'k' : 'p';
    picture.push_back(std::move(line));
  }
  return make_chart(picture, form);
}

/// The basic structures, `wales` x `courses`, each knitted from either side first.
inline std::vector<NamedChart> basic_structures(int wales, int courses, Form form) {
  const std::vector<std::pair<std::string, std::function<bool(int, int)>>> faces{
      {"jersey", [](int, int) { return true; }},
      {"reverse jersey", [](int, int) { return false; }},
      {"garter", [](int course, int) { return course % 2 == 0; }},
      {"reverse garter", [](int course, int) { return course % 2 == 1; }},
      {"rib 1x1", [](int, int wale) { return wale % 2 == 0; }},
      {"rib 2x2", [](int, int wale) { return wale / 2 % 2 == 0; }},
      {"seed", [](int course, int wale) { return (course + wale) % 2 == 0; }},
      {"moss", [](int course, int wale) { return (course / 2 + wale) % 2 == 0; }}};
  std::vector<NamedChart> charts;
  for (const auto& [name, face] : faces)
    for (const Side from : {Side::left, Side::right}) {
      Chart chart = make_chart_of(wales, courses, form, face);
      chart.first_course_from = from;
      charts.push_back({name + (from == Side::left ? ", from left" : ", from right"), std::move(chart)});
    }
  return charts;
}

/// Random mixtures of 3 to 8 wales, or for tubes 8, 10 or 12, and 3 to 8 courses.
inline std::vector<NamedChart> random_mixtures(unsigned count, Form form) {
  std::vector<NamedChart> charts;
  for (unsigned seed = 0; seed < count; ++seed) {
    const int wales = form == Form::tube ? 8 + 2 * static_cast<int>(seed % 3) : 3 + static_cast<int>(seed % 6);
    Chart chart = make_random_chart(wales, 3 + static_cast<int>(seed * 5 % 6), form, seed + 100);
    chart.first_course_from = seed % 2 ? Side::left : Side::right;
    charts.push_back({"mixture " + std::to_string(seed), std::move(chart)});
  }
  return charts;
}

/// All of the above, flat and round.
inline std::vector<NamedChart> all_structures() {
  std::vector<NamedChart> charts;
  for (const Form form : {Form::flat, Form::tube})
    for (const auto& some : {basic_structures(form == Form::tube ? 8 : 6, 5, form), random_mixtures(12, form)})
      for (NamedChart named : some) {
        named.name += form == Form::tube ? ", tube" : ", flat";
        charts.push_back(std::move(named));
      }
  return charts;
}

}  // namespace wale
