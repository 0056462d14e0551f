/// Text in, Scene out: the pipeline, one pass a line.
#pragma once

#include <optional>
#include <string>

#include "compiler/knitout_options.hpp"
#include "compiler/passes.hpp"
#include "compiler/yarn_materials.hpp"

namespace wale {

/// Every noun on the way from a program to a fabric.
struct Compiled {
  std::string name;
  Program program;
  StitchGraph graph;
  Arrangement arrangement;
  Fabric fabric;
  Gauge gauge;
  std::vector<Crossing> crossings;
};

struct CompiledChart : Compiled {
  Chart chart;
};

/// A chart to a fabric. Of a periodic one, program, graph and arrangement are those of the larger piece in which its
/// repeat was drawn; fabric and crossings are the repeat's. Nothing if an error was reported. `segments_per_stitch` is
/// at least 8.
std::optional<CompiledChart> compile_chart(const Source&, const ChartOverrides&, int segments_per_stitch, Diagnostics&);
std::optional<CompiledChart> compile_chart(Chart, int segments_per_stitch, Diagnostics&);

/// Whether a text is a machine's program, by its suffix or its first line.
bool holds_knitout(const Source&);

/// What a knitout file makes.
struct Knitted {
  Program program;
  StitchGraph graph;
};

/// A knitout file to its stitch graph. Gives what there is even if an error was reported: faulty lines are left out,
/// and faulty instructions done as far as they make sense.
Knitted knit_knitout(const Source&, const KnitoutOptions&, Diagnostics&);

/// A knitout file to a fabric, whatever it knits, its carriers with the yarns `given` where those say otherwise than
/// its headers. Nothing if an error was reported; it is one if the fabric drawn has not exactly the crossings that the
/// stitch graph demands.
std::optional<Compiled> compile_knitout(const Source&, const KnitoutOptions&, const YarnMaterials& given,
                                        int segments_per_stitch, Diagnostics&);

/// What a scene's fabric is compiled with in place of what its file says. Wales, courses and `periodic` are of charts
/// only.
struct FabricChanges {
  std::optional<int> segments_per_stitch;  ///< at least 8
  std::optional<int> wales, courses;
  std::optional<bool> periodic;
};

/// A scene file, and the chart or knitout file that it names (read through `sources`, relative to the scene file), to a
/// Scene.
std::optional<Scene> compile_scene(const Source&, Sources& sources, Diagnostics&, const FabricChanges& = {});

}  // namespace wale
