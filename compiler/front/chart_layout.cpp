#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "compiler/front/chart_parts.hpp"
#include "compiler/front/limits.hpp"
#include "compiler/jamming.hpp"

namespace wale {
namespace {

Span start_of(const Span& span) { return {span.source, span.begin, span.begin}; }

class Layouter {
 public:
  Layouter(const ChartHead& head, const ChartYarns& yarns, std::vector<Band> bands, const ChartOverrides& overrides,
           Diagnostics& say)
      : head_(head), yarns_(yarns), bands_(std::move(bands)), overrides_(overrides), say_(say) {}

  std::optional<Chart> lay_out() {
    settle_wales();
    settle_courses();
    if (!good_) return std::nullopt;
    for (const Band& band : bands_) check_fit(band);
    check_size();
    if (!good_) return std::nullopt;
    Chart chart{head_.name,
                head_.form,
                yarns_.yarns,
                {},
                head_.first_course_from,
                head_.start,
                head_.end,
                overrides_.periodic,
                start_of(head_.wales_span)};
    for (const Band& band : bands_) {
      if (overrides_.periodic) check_repeat(band);
      add(band, chart);
    }
    return chart;
  }

 private:
  void fail(std::string_view code, Span span, std::string message, std::string hint) {
    say_.error(code, span, std::move(message), std::move(hint));
    good_ = false;
  }

  static int width(const Band& band) {
    return std::accumulate(band.panels.begin(), band.panels.end(), 0,
                           [](int sum, const Panel& panel) { return sum + panel.wales.value_or(0); });
  }

  /// What the first band with a width of its own asks for.
  int drawn_wales() const {
    for (const Band& band : bands_) {
      if (const int sum = width(band); sum > 0) return sum;
      for (const Panel& panel : band.panels) {
        if (panel.stitches.in_place) return panel.stitches.wales();
        if (panel.yarns.in_place) return panel.yarns.wales();
      }
    }
    return 0;
  }

  void settle_wales() {
    wales_ = head_.wales ? *head_.wales : drawn_wales();
    if (overrides_.wales) {
      if (*overrides_.wales < 1 || *overrides_.wales > limits::most_wales) {
        fail("C013", start_of(head_.wales_span), fmt::format("a chart cannot be {} wales wide", *overrides_.wales),
             fmt::format("ask for 1 to {} wales", limits::most_wales));
      }
      wales_ = *overrides_.wales;
    }
    if (wales_ == 0) {
      fail("Y005", start_of(head_.wales_span), "\"wales\" is missing in a chart",
           "add its width, as in `wales: 12`; only a picture or panels have a width of their own");
    }
  }

  void settle_courses() {
    const int courses = std::accumulate(bands_.begin(), bands_.end(), 0,
                                        [](int sum, const Band& band) { return sum + band.courses.value_or(0); });
    if (!overrides_.courses || *overrides_.courses == courses) return;
    if (*overrides_.courses < 1 || *overrides_.courses > limits::most_courses) {
      fail("C013", start_of(head_.wales_span), fmt::format("a chart cannot be {} courses high", *overrides_.courses),
           fmt::format("ask for 1 to {} courses", limits::most_courses));
    } else if (bands_.size() > 1) {
      fail("C013", bands_.front().span,
           fmt::format("{} courses are asked for, but the bands of this chart have {}", *overrides_.courses, courses),
           "only a chart of one band can be stretched; change the bands, or leave the courses to the chart");
    } else {
      bands_.front().courses = *overrides_.courses;
    }
  }

  void check_fit(const Band& band) {
    const bool side_by_side = band.panels.front().wales.has_value();
    if (side_by_side && width(band) != wales_) {
      fail("C006", band.panels.front().span,
           fmt::format("the panels of this band are {} wales wide, the chart {}", width(band), wales_),
           "change the panels so that their wales add up to the chart's");
      return;
    }
    for (const Panel& panel : band.panels) {
      check_fit(panel.stitches, panel.wales.value_or(wales_), *band.courses);
      // A yarn picture of the whole band is shared by its panels, and laid over all of them.
      check_fit(panel.yarns, panel.own_yarns ? panel.wales.value_or(wales_) : wales_, *band.courses);
      if (!good_) return;
    }
  }

  void check_fit(const Tile& tile, int wales, int courses) {
    if (!tile.in_place || (tile.wales() <= wales && tile.courses() <= courses)) return;
    fail("C007", start_of(tile.span),
         fmt::format("a picture of {} wales x {} courses does not fit into {} x {}", tile.wales(), tile.courses(),
                     wales, courses),
         "draw it smaller, or make room for it; a smaller picture is repeated");
  }

  /// Where one structure fills the whole width, or the whole height, it should not be cut off there.
  void check_repeat(const Band& band) {
    for (const Panel& panel : band.panels)
      for (const Tile* tile : {&panel.stitches, &panel.yarns}) {
        if (band.panels.size() == 1) check_even(*tile, tile->wales(), wales_, "wales");
        if (bands_.size() == 1) check_even(*tile, tile->courses(), *band.courses, "courses");
      }
  }

  void check_even(const Tile& tile, int every, int count, std::string_view what) {
    if (count % every == 0) return;
    say_.warning("C023", start_of(tile.span),
                 fmt::format("this comes again every {} {}, but the periodic fabric after {}: there is a seam", every,
                             what, count),
                 fmt::format("ask for a multiple of {} {}", every, what));
  }

  void check_size() {
    const long courses = std::accumulate(bands_.begin(), bands_.end(), 0L,
                                         [](long sum, const Band& band) { return sum + *band.courses; });
    if (courses <= limits::most_courses && courses * wales_ <= limits::most_cells) return;
    fail("C012", start_of(head_.wales_span),
         fmt::format("this chart is too big: {} wales x {} courses", wales_, courses),
         fmt::format("keep to {} courses and {} stitches", limits::most_courses, limits::most_cells));
  }

  void add(const Band& band, Chart& chart) {
    const std::size_t first = chart.courses.size();
    chart.courses.resize(first + static_cast<std::size_t>(*band.courses));
    for (int course = 0; course < *band.courses; ++course) {
      std::vector<Cell>& row = chart.courses[first + static_cast<std::size_t>(course)];
      row.reserve(static_cast<std::size_t>(wales_));
      const bool turned = is_wrong_side(static_cast<int>(first) + course);
      for (const Panel& panel : band.panels) {
        const int left = static_cast<int>(row.size());
        for (int wale = 0; wale < panel.wales.value_or(wales_); ++wale) {
          row.push_back(cell(band, panel, course, wale, panel.own_yarns ? wale : left + wale, turned));
        }
      }
    }
  }

  /// The knitter looks at the back of the rows that run from left to right, seen from the face.
  bool is_wrong_side(int course) const {
    if (head_.form == Form::tube) return false;
    const bool from_first_side = course % 2 == 0;
    return from_first_side != (head_.first_course_from == Side::right);
  }

  Cell cell(const Band& band, const Panel& panel, int course, int wale, int yarn_wale, bool turned) {
    const Tile::Cell& stitch = panel.stitches.at(course, wale);
    const Tile::Cell& yarn = panel.yarns.at(course, yarn_wale);
    const bool swapped = head_.worked && panel.stitches.drawn && turned;
    const bool only_yarn_drawn = panel.yarns.drawn && !panel.stitches.drawn;
    const GivenLength& length = stitch_length(band, yarn.value);
    warn_if_jammed(yarn.value, length);
    return {static_cast<Stitch>(swapped ? 1 - stitch.value : stitch.value), yarn.value, length.value,
            only_yarn_drawn ? yarn.span : stitch.span};
  }

  const GivenLength& stitch_length(const Band& band, int yarn) {
    const auto& of_yarn = yarns_.stitch_lengths[static_cast<std::size_t>(yarn)];
    const GivenLength& chosen = band.stitch_length ? *band.stitch_length : of_yarn ? *of_yarn : head_.stitch_length;
    if (!overrides_.stitch_length || &chosen == &head_.stitch_length) return chosen;
    if (replaced_.insert(chosen.span.begin).second) {
      say_.warning("C022", chosen.span,
                   fmt::format("this stitch length is replaced by {:g} mm", *overrides_.stitch_length * 1e3),
                   "leave the stitch length out of the scene to keep those of the chart");
    }
    return head_.stitch_length;
  }

  void warn_if_jammed(int yarn, const GivenLength& length) {
    const ChartYarn& of = yarns_.yarns[static_cast<std::size_t>(yarn)];
    if (!jams(length.value, of.material) || !jammed_.insert({yarn, length.value}).second) return;
    const Span place =
        length.span.begin == length.span.end ? yarns_.spans[static_cast<std::size_t>(yarn)] : length.span;
    warn_of_jamming(length.value, of.material, of.name, place, say_);
  }

  const ChartHead& head_;
  const ChartYarns& yarns_;
  std::vector<Band> bands_;
  const ChartOverrides& overrides_;
  Diagnostics& say_;
  int wales_ = 0;
  bool good_ = true;
  std::set<std::pair<int, double>> jammed_;
  std::set<std::uint32_t> replaced_;
};

}  // namespace

std::optional<Chart> lay_out(const ChartHead& head, const ChartYarns& yarns, std::vector<Band> bands,
                             const ChartOverrides& overrides, Diagnostics& say) {
  return Layouter(head, yarns, std::move(bands), overrides, say).lay_out();
}

}  // namespace wale
