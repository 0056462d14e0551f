#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "compiler/fields.hpp"
#include "compiler/front/chart_parts.hpp"
#include "compiler/front/limits.hpp"

namespace wale {
namespace {

constexpr double default_stitch_length = 7.23e-3;  // m; Ding et al. 2023, Table 1

// Munden's constants of a fully relaxed jersey: courses per length = k_c / l, wales per length = k_w / l.
constexpr double munden_courses = 5.5, munden_wales = 4.2;

constexpr Range stitch_lengths{limits::least_stitch_length, limits::most_stitch_length};
constexpr Range counts_per_10cm{0.1, 2000};

std::optional<GivenLength> read_length(const YamlNode* node, Diagnostics& say) {
  if (!node) return std::nullopt;
  const auto value = read_quantity(*node, "a stitch length", dimensions::length, stitch_lengths, say);
  if (!value) return std::nullopt;
  return GivenLength{*value, node->span};
}

/// The stitch length at which a relaxed jersey would have these counts; with both, by its stitch density k_s = k_c k_w.
std::optional<GivenLength> read_counts(const YamlNode& gauge, Diagnostics& say) {
  double constants = 1, per_metre = 1;
  int known = 0;
  for (const auto& [key, constant] :
       {std::pair{"wales_per_10cm", munden_wales}, {"courses_per_10cm", munden_courses}}) {
    const YamlNode* node = gauge.find(key);
    if (!node) continue;
    const auto count = read_quantity(*node, fmt::format("\"{}\"", key), dimensions::ratio, counts_per_10cm, say);
    if (!count) continue;
    constants *= constant;
    per_metre *= *count * 10;
    ++known;
  }
  if (known == 0) return std::nullopt;
  return GivenLength{std::pow(constants / per_metre, 1.0 / known), gauge.span};
}

std::optional<GivenLength> read_gauge(const YamlNode* node, Diagnostics& say) {
  if (!node) return std::nullopt;
  const Fields gauge(*node, "a gauge", {"stitch_length", "wales_per_10cm", "courses_per_10cm"}, say);
  if (!gauge.is_map()) return std::nullopt;
  const auto counted = read_counts(*node, say);
  const auto length = read_length(gauge.find("stitch_length"), say);
  return length ? length : counted;
}

GivenLength read_stitch_length(const YamlNode& root, const ChartOverrides& overrides, Diagnostics& say) {
  const auto length = read_length(root.find("stitch_length"), say);
  const auto gauge = read_gauge(root.find("gauge"), say);
  if (length && root.find("gauge") && root.find("gauge")->find("stitch_length")) {
    say.error("C011", root.find("gauge")->find("stitch_length")->span, "the stitch length is given twice",
              "keep `stitch_length:` or `gauge: {stitch_length: ...}`");
  }
  const GivenLength fallback{default_stitch_length, {root.span.source, root.span.begin, root.span.begin}};
  GivenLength chosen = length ? *length : gauge.value_or(fallback);
  if (overrides.stitch_length) chosen.value = *overrides.stitch_length;
  return chosen;
}

void read_edges(const YamlNode* node, ChartHead& head, Diagnostics& say) {
  if (!node) return;
  const Fields edges(*node, "the edges", {"start", "end", "sides"}, say);
  if (const YamlNode* start = edges.find("start")) {
    if (const auto word = read_word(*start, "the start", {"cast_on", "open"}, say)) {
      head.start = *word == 0 ? Edge::cast_on : Edge::open;
    }
  }
  if (const YamlNode* end = edges.find("end")) {
    if (const auto word = read_word(*end, "the end", {"bind_off", "open"}, say)) {
      head.end = *word == 0 ? Edge::bind_off : Edge::open;
    }
  }
  if (const YamlNode* sides = edges.find("sides")) read_word(*sides, "the sides", {"free"}, say);
}

void read_colorwork(const YamlNode* node, Diagnostics& say) {
  if (!node) return;
  const auto word = read_word(*node, "the colourwork", {"intarsia", "float", "inlay"}, say);
  if (!word || *word == 0) return;
  say.warning("C021", node->span, fmt::format("colourwork \"{}\" is knitted as intarsia", node->text),
              "yarns change at the stitch and nothing floats behind; write `colorwork: intarsia` to say so");
}

}  // namespace

ChartHead read_head(const YamlNode& root, const ChartOverrides& overrides, Diagnostics& say) {
  ChartHead head;
  head.name = std::filesystem::path(root.span.source->name).stem().string();
  if (const YamlNode* name = root.find("name")) head.name = read_text(*name, "the name", say).value_or(head.name);
  if (const YamlNode* form = root.find("form")) {
    if (const auto word = read_word(*form, "the form", {"flat", "tube"}, say)) {
      head.form = *word == 0 ? Form::flat : Form::tube;
    }
  }
  head.wales_span = {root.span.source, root.span.begin, root.span.begin};
  if (const YamlNode* wales = root.find("wales")) {
    head.wales = read_count(*wales, "the number of wales", 1, limits::most_wales, say);
    head.wales_span = wales->span;
  }
  if (const YamlNode* first = root.find("first_row")) {
    if (const auto word = read_word(*first, "the first row", {"right_to_left", "left_to_right"}, say)) {
      head.first_course_from = *word == 0 ? Side::right : Side::left;
    }
  }
  if (const YamlNode* view = root.find("view")) {
    head.worked = read_word(*view, "the view", {"face", "worked"}, say).value_or(0) == 1;
  }
  head.stitch_length = read_stitch_length(root, overrides, say);
  read_edges(root.find("edges"), head, say);
  read_colorwork(root.find("colorwork"), say);
  return head;
}

}  // namespace wale
