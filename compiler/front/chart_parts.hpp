/// What stands between the text of a chart and its cells: the reader's own nouns.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/chart.hpp"
#include "compiler/front/picture.hpp"

namespace wale {

/// A length, and the text that asked for it.
struct GivenLength {
  double value = 0;  ///< m
  Span span;
};

enum class SymbolMeaning : std::uint8_t { knit, purl, unsupported };

/// From symbols to stitches; `k` and `p` are always there.
using Legend = std::map<std::string, SymbolMeaning>;

/// Everything that a chart says once, for all its bands.
struct ChartHead {
  std::string name;
  Form form = Form::flat;
  std::optional<int> wales;
  Span wales_span;
  Side first_course_from = Side::right;
  Edge start = Edge::cast_on, end = Edge::bind_off;
  bool worked = false;  ///< pictures show each row as its knitter sees it
  GivenLength stitch_length;
};

struct ChartYarns {
  std::vector<ChartYarn> yarns;
  std::vector<std::optional<GivenLength>> stitch_lengths;  ///< by yarn
  std::vector<Span> spans;                                 ///< by yarn: its name
  std::map<std::string, int> by_symbol;                    ///< what may stand in a picture of yarns
  int find(const std::string& name) const;                 ///< -1 if there is none
};

/// Named pictures; nothing where the picture was faulty and has been reported.
using Patterns = std::map<std::string, std::optional<Picture>>;

/// A piece of cloth that repeats from the lower left corner on: of stitches (0 knit, 1 purl) or of yarns (indices).
struct Tile {
  struct Cell {
    int value = 0;
    Span span;
  };
  std::vector<std::vector<Cell>> rows;  ///< rows[0] is the first course
  Span span;
  bool drawn = false;     ///< from a picture: each cell has its own place in the text
  bool in_place = false;  ///< drawn where it is used, so it must fit there
  int wales() const { return static_cast<int>(rows.front().size()); }
  int courses() const { return static_cast<int>(rows.size()); }
  const Cell& at(int course, int wale) const {
    return rows[static_cast<std::size_t>(course % courses())][static_cast<std::size_t>(wale % wales())];
  }
};

struct Panel {
  Tile stitches, yarns;
  std::optional<int> wales;  ///< nothing: as wide as the chart
  Span span;
  bool own_yarns = false;  ///< false: the yarns are the band's, and run on from panel to panel
};

struct Band {
  std::vector<Panel> panels;   ///< left to right, at least one
  std::optional<int> courses;  ///< nothing: as high as its highest picture
  std::optional<GivenLength> stitch_length;
  Span span;
};

ChartHead read_head(const YamlNode& root, const ChartOverrides&, Diagnostics&);
Legend read_legend(const YamlNode& root, Diagnostics&);
ChartYarns read_yarns(const YamlNode& root, Diagnostics&);
Patterns read_patterns(const YamlNode& root, const Legend&, Diagnostics&);

/// What bands may refer to.
struct Vocabulary {
  const Legend& legend;
  const Patterns& patterns;
  const ChartYarns& yarns;
};

/// Bands in knitting order; those with a fault are reported and left out.
std::vector<Band> read_bands(const YamlNode& root, const Vocabulary&, Diagnostics&);

/// Lays the bands out cell by cell. Nothing if they do not fit each other or `overrides`.
std::optional<Chart> lay_out(const ChartHead&, const ChartYarns&, std::vector<Band>, const ChartOverrides&,
                             Diagnostics&);

}  // namespace wale
