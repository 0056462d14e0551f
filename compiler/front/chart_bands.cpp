#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compiler/fields.hpp"
#include "compiler/front/chart_parts.hpp"
#include "compiler/front/limits.hpp"
#include "compiler/front/stitch_patterns.hpp"

namespace wale {
namespace {

class BandsReader {
 public:
  BandsReader(const Vocabulary& words, Diagnostics& say) : words_(words), say_(say) {}

  std::optional<Band> read(const YamlNode& node) {
    const Fields fields(node, "a band", {"stitch", "courses", "yarn", "stitch_length", "panels"}, say_);
    if (!fields.is_map()) return std::nullopt;
    Band band;
    band.span = node.span;
    if (const YamlNode* courses = fields.find("courses")) {
      band.courses = read_count(*courses, "the number of courses", 1, limits::most_courses, say_);
      if (!band.courses) good_ = false;
    }
    if (const YamlNode* length = fields.find("stitch_length")) {
      const auto value = read_quantity(*length, "a stitch length", dimensions::length,
                                       {limits::least_stitch_length, limits::most_stitch_length}, say_);
      if (value) band.stitch_length = GivenLength{*value, length->span};
    }
    const Tile yarns = read_yarns(fields.find("yarn"), node.span);
    if (const YamlNode* panels = fields.find("panels")) {
      if (const YamlNode* stitch = fields.find("stitch")) {
        fail("C011", stitch->span, "a band has a stitch or panels, not both", "move the stitch into a panel");
      }
      read_panels(*panels, yarns, band);
    } else if (const YamlNode* stitch =
                   fields.require("stitch", "add `stitch: jersey`, or another structure or pattern")) {
      band.panels.push_back({read_stitches(*stitch), yarns, {}, stitch->span});
    } else {
      good_ = false;
    }
    if (!good_) return std::nullopt;
    settle_courses(band);
    return good_ ? std::optional(std::move(band)) : std::nullopt;
  }

 private:
  void fail(std::string_view code, Span span, std::string message, std::string hint) {
    say_.error(code, span, std::move(message), std::move(hint));
    good_ = false;
  }

  void read_panels(const YamlNode& node, const Tile& yarns, Band& band) {
    if (node.kind != YamlNode::Kind::list || node.items.empty()) {
      fail("Y004", node.span, "\"panels\" must be a list, from left to right",
           "write one panel a line, as in `- {stitch: jersey, wales: 6}`");
      return;
    }
    for (const YamlNode& item : node.items) {
      const Fields fields(item, "a panel", {"stitch", "wales", "yarn"}, say_);
      const YamlNode* stitch = fields.require("stitch", "add `stitch: jersey`, or another structure or pattern");
      const YamlNode* wales = fields.require("wales", "add the panel's width, as in `wales: 6`");
      if (!stitch || !wales) {
        good_ = false;
        continue;
      }
      Panel panel{read_stitches(*stitch), yarns, read_count(*wales, "the number of wales", 1, limits::most_wales, say_),
                  item.span};
      if (!panel.wales) good_ = false;
      if (const YamlNode* yarn = fields.find("yarn")) {
        panel.yarns = read_yarns(yarn, item.span);
        panel.own_yarns = true;
      }
      band.panels.push_back(std::move(panel));
    }
  }

  /// A band without a number of courses is as high as the pictures in it.
  void settle_courses(Band& band) {
    if (band.courses) return;
    for (const Panel& panel : band.panels) {
      for (const Tile* tile : {&panel.stitches, &panel.yarns}) {
        if (tile->drawn) band.courses = std::max(band.courses.value_or(0), tile->courses());
      }
    }
    if (!band.courses) {
      fail("Y005", {band.span.source, band.span.begin, band.span.begin}, "\"courses\" is missing in a band",
           "add its height, as in `courses: 12`; only a picture has a height of its own");
    }
  }

  Tile read_stitches(const YamlNode& node) {
    if (is_picture(node)) {
      std::vector<std::string> symbols;
      for (const auto& [symbol, meaning] : words_.legend) symbols.push_back(symbol);
      const auto picture = read_picture(node, "stitch", symbols, say_);
      if (!picture) good_ = false;
      return picture ? stitches_of(*picture, true) : single(0, node.span);
    }
    const auto name = read_text(node, "a stitch", say_);
    if (!name) {
      good_ = false;
      return single(0, node.span);
    }
    if (const auto known = words_.patterns.find(*name); known != words_.patterns.end()) {
      if (!known->second) good_ = false;  // reported where it is drawn
      return known->second ? stitches_of(*known->second, false) : single(0, node.span);
    }
    const auto built_in = built_in_stitch(*name);
    if (!built_in) report_unknown_stitch(node);
    return built_in ? stitches_of(*built_in, node.span) : single(0, node.span);
  }

  void report_unknown_stitch(const YamlNode& node) {
    std::vector<std::string_view> known = built_in_stitch_names();
    for (const auto& [name, picture] : words_.patterns) known.push_back(name);
    fail("C002", node.span, fmt::format("unknown stitch \"{}\"", node.text), suggest(node.text, known));
  }

  static Tile single(int value, const Span& span) { return {{{{value, span}}}, span}; }

  static Tile stitches_of(const StitchTile& stitches, const Span& span) {
    Tile tile;
    tile.span = span;
    for (const std::vector<Stitch>& row : stitches.rows) {
      tile.rows.emplace_back();
      for (const Stitch stitch : row) tile.rows.back().push_back({static_cast<int>(stitch), span});
    }
    return tile;
  }

  Tile stitches_of(const Picture& picture, bool in_place) {
    Tile tile;
    tile.span = picture.span;
    tile.drawn = true;
    tile.in_place = in_place;
    for (const auto& row : picture.rows) {
      tile.rows.emplace_back();
      for (const PictureCell& cell : row) {
        const SymbolMeaning meaning = words_.legend.at(cell.symbol);
        if (meaning == SymbolMeaning::unsupported) report_unsupported(cell);
        tile.rows.back().push_back(
            {static_cast<int>(meaning == SymbolMeaning::purl ? Stitch::purl : Stitch::knit), cell.span});
      }
    }
    return tile;
  }

  void report_unsupported(const PictureCell& cell) {
    good_ = false;
    if (!refused_.insert(cell.symbol).second) return;
    Span whole = cell.span;
    whole.end = whole.begin + static_cast<std::uint32_t>(cell.symbol.size());
    fail("C005", whole,
         fmt::format("the stitch of symbol \"{}\" is not supported in charts yet; knit and purl are", cell.symbol),
         "draw this cell with k or p");
  }

  Tile read_yarns(const YamlNode* node, const Span& band) {
    if (!node) return single(0, band);
    if (is_picture(*node)) return draw_yarns(*node);
    if (node->kind == YamlNode::Kind::list && !node->items.empty()) {
      Tile tile;
      tile.span = node->span;
      for (const YamlNode& item : node->items) tile.rows.push_back({{find_yarn(item), item.span}});
      return tile;
    }
    return single(find_yarn(*node), node->span);
  }

  Tile draw_yarns(const YamlNode& node) {
    std::vector<std::string> symbols;
    for (const auto& [symbol, yarn] : words_.yarns.by_symbol) symbols.push_back(symbol);
    const auto picture = read_picture(node, "yarn", symbols, say_);
    if (!picture) {
      good_ = false;
      return single(0, node.span);
    }
    Tile tile;
    tile.span = node.span;
    tile.drawn = tile.in_place = true;
    for (const auto& row : picture->rows) {
      tile.rows.emplace_back();
      for (const PictureCell& cell : row)
        tile.rows.back().push_back({words_.yarns.by_symbol.at(cell.symbol), cell.span});
    }
    return tile;
  }

  int find_yarn(const YamlNode& node) {
    const auto name = read_text(node, "a yarn", say_);
    if (!name) good_ = false;
    const int yarn = name ? words_.yarns.find(*name) : 0;
    if (yarn >= 0) return yarn;
    std::vector<std::string_view> known;
    for (const ChartYarn& one : words_.yarns.yarns) known.push_back(one.name);
    fail("C008", node.span, fmt::format("unknown yarn \"{}\"", *name), suggest(*name, known));
    return 0;
  }

  const Vocabulary& words_;
  Diagnostics& say_;
  bool good_ = true;
  std::set<std::string> refused_;
};

}  // namespace

std::vector<Band> read_bands(const YamlNode& root, const Vocabulary& words, Diagnostics& say) {
  std::vector<Band> bands;
  const YamlNode* node = root.find("bands");
  if (!node) return bands;
  if (node->kind != YamlNode::Kind::list || node->items.empty()) {
    say.error("Y004", node->span, "\"bands\" must be a list, in knitting order",
              "write one band a line, as in `- {stitch: jersey, courses: 12}`");
    return bands;
  }
  for (const YamlNode& item : node->items) {
    if (auto band = BandsReader(words, say).read(item)) bands.push_back(std::move(*band));
  }
  return bands;
}

}  // namespace wale
