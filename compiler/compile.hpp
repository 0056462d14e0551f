/// Text in, Scene out: the pipeline, one pass a line.
#pragma once

#include <optional>
#include <string>

#include "compiler/passes.hpp"

namespace wale {

/// Every noun on the way from a chart to a fabric.
struct Compiled {
  Chart chart;
  Program program;
  StitchGraph graph;
  Layout layout;
  Fabric fabric;
  Gauge gauge;
  std::vector<Crossing> crossings;
};

/// A chart to a fabric. Nothing if an error was reported. `segments_per_stitch` is at least 6.
std::optional<Compiled> compile_chart(const Source&, const ChartOverrides&, int segments_per_stitch, Diagnostics&);
std::optional<Compiled> compile_chart(Chart, int segments_per_stitch, Diagnostics&);

/// What a knitout file makes.
struct Knitted {
  Program program;
  StitchGraph graph;
};

struct KnitoutOptions {
  Crop crop;
  StitchLengths stitch_lengths;  ///< where they differ from what is assumed
};

/// A knitout file to its stitch graph. Gives what there is even if an error was reported: faulty lines are left out,
/// and faulty instructions done as far as they make sense.
Knitted knit_knitout(const Source&, const KnitoutOptions&, Diagnostics&);

/// A scene file, and the chart that it names (read through `sources`, relative to the scene file), to a Scene.
std::optional<Scene> compile_scene(const Source&, Sources& sources, Diagnostics&);

}  // namespace wale
