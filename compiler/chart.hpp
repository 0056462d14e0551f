/// A knitting chart, expanded: one cell a stitch, as seen on the technical face.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/source.hpp"
#include "compiler/yarn_materials.hpp"
#include "sim/fabric.hpp"

namespace wale {

enum class Stitch : std::uint8_t { knit, purl };  ///< as seen from the face; from outside on a tube
enum class Form : std::uint8_t { flat, tube };
enum class Side : std::uint8_t { left, right };

struct ChartYarn {
  std::string name;
  Material material;
  std::string color = "#c9b79c";
};

struct Cell {
  Stitch stitch = Stitch::knit;
  int yarn = 0;              ///< index into Chart::yarns
  double stitch_length = 0;  ///< yarn length of this stitch, m
  Span span;                 ///< the text that asked for this cell
};

enum class Edge : std::uint8_t { cast_on, bind_off, open };

struct Chart {
  std::string name;
  Form form = Form::flat;
  std::vector<ChartYarn> yarns;
  std::vector<std::vector<Cell>> courses;  ///< first knitted first; each from left to right, equal widths
  Side first_course_from = Side::right;    ///< where the first course begins: right is "right to left"
  Edge start = Edge::cast_on;              ///< cast_on or open
  Edge end = Edge::bind_off;               ///< bind_off or open
  bool periodic = false;                   ///< one repeat of a fabric without end: its edges are left out, and every
                                           ///< course is a yarn of its own that runs from left to right
  Span span;

  int wales() const { return courses.empty() ? 0 : static_cast<int>(courses.front().size()); }
  std::vector<Material> materials() const {
    std::vector<Material> of_yarns;
    for (const ChartYarn& yarn : yarns) of_yarns.push_back(yarn.material);
    return of_yarns;
  }
  int course_count() const { return static_cast<int>(courses.size()); }
};

/// What a scene or a command line may change of a chart: a number to search over.
struct ChartOverrides {
  std::optional<int> wales, courses;    ///< one-band charts stretch; others are refused if they do not tile
  std::optional<double> stitch_length;  ///< m
  YarnMaterials materials;
  bool periodic = false;  ///< the chart is one repeat of a fabric without end
};

/// The picture of a chart, last line the first course, with course numbers and yarns; what `--show chart` prints.
std::string print(const Chart&);

}  // namespace wale
