/// A scene file, read: which chart, changed how, and what is done to its fabric.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/chart.hpp"
#include "compiler/crop.hpp"
#include "compiler/diagnostic.hpp"
#include "sim/scene.hpp"

namespace wale {

/// A Scene less its fabric.
struct ParsedScene {
  std::string name;
  std::string pattern_path;  ///< of the chart or knitout file, resolved against the scene file's folder
  Span pattern_span;
  ChartOverrides overrides;
  Crop crop;  ///< of a knitout file
  int segments_per_stitch = 12;
  double thickness = 0;  ///< 2r of sigma = F / (2r S_R), m; 0: twice the contact diameter
  std::vector<Stage> stages;
};

/// Nothing if an error was reported.
std::optional<ParsedScene> parse_scene(const Source&, Diagnostics&);

/// The text of the scene's chart. Null, with a report at the place that names it, if it cannot be read.
const Source* read_pattern(const ParsedScene&, Sources&, Diagnostics&);

}  // namespace wale
