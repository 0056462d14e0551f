/// Text in, Scene out: the pipeline, one pass a line.
#pragma once

#include <optional>
#include <string>

#include "compiler/passes.hpp"

namespace wale {

/// What a knitout file does not say of its yarns.
struct YarnChoice {
  Material material;               ///< of every carrier
  double stitch_length = 7.23e-3;  ///< m, of loops that the program gives none
};

/// From what a scene or a command line may change of a chart.
YarnChoice yarn_choice(const ChartOverrides&);

/// Every noun on the way from a program to a fabric.
struct Compiled {
  std::string name;
  Program program;
  StitchGraph graph;
  Fabric fabric;
  Gauge gauge;
  std::vector<Crossing> crossings;
};

struct CompiledChart : Compiled {
  Chart chart;
  Layout layout;
};

struct CompiledKnitout : Compiled {
  Arrangement arrangement;
};

/// A chart to a fabric. Nothing if an error was reported. `segments_per_stitch` is at least 8.
std::optional<CompiledChart> compile_chart(const Source&, const ChartOverrides&, int segments_per_stitch, Diagnostics&);
std::optional<CompiledChart> compile_chart(Chart, int segments_per_stitch, Diagnostics&);

/// A knitout file to a fabric, whatever it knits. Nothing if an error was reported; it is one if the fabric drawn has not
/// exactly the crossings that the stitch graph demands.
std::optional<CompiledKnitout> compile_knitout(const Source&, const YarnChoice&, int segments_per_stitch, Diagnostics&);

/// What a knitout file makes.
struct Knitted {
  Program program;
  StitchGraph graph;
};

/// A knitout file to its stitch graph. Gives what there is even if an error was reported: faulty lines are left out,
/// and faulty instructions done as far as they make sense.
Knitted knit_knitout(const Source&, Diagnostics&);

/// A scene file, and the chart that it names (read through `sources`, relative to the scene file), to a Scene.
std::optional<Scene> compile_scene(const Source&, Sources& sources, Diagnostics&);

}  // namespace wale
