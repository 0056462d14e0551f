#include "compiler/compile.hpp"

#include <algorithm>

#include "compiler/demand.hpp"
#include "compiler/front/scene.hpp"
#include "compiler/passes/program_codes.hpp"

namespace wale {

std::optional<Compiled> compile_chart(const Source& source, const ChartOverrides& overrides, int segments_per_stitch,
                                      Diagnostics& say) {
  auto chart = passes::parse_chart(source, overrides, say);
  if (!chart) return std::nullopt;
  return compile_chart(std::move(*chart), segments_per_stitch, say);
}

std::optional<Compiled> compile_chart(Chart chart, int segments_per_stitch, Diagnostics& say) {
  auto program = passes::lower_chart(chart, say);
  if (!program) return std::nullopt;
  passes::check_program(*program, say);
  if (say.failed()) return std::nullopt;
  auto graph = passes::knit(*program, say);
  if (!graph) return std::nullopt;
  passes::check_graph(*graph, say);
  auto layout = passes::place(*graph, chart, say);
  if (!layout) return std::nullopt;
  const auto curves = passes::thread(*layout, chart, say);
  if (!curves) return std::nullopt;
  auto fabric = passes::fit(*curves, chart, segments_per_stitch, say);
  if (!fabric || say.failed()) return std::nullopt;
  Gauge gauge = gauge_of(*layout, *fabric);
  auto crossings = demanded_crossings(*layout, *fabric);
  return Compiled{std::move(chart),   std::move(*program), std::move(*graph),   std::move(*layout),
                  std::move(*fabric), std::move(gauge),    std::move(crossings)};
}

Knitted knit_knitout(const Source& source, const KnitoutOptions& options, Diagnostics& say) {
  const std::size_t errors = say.error_count();
  Program program = passes::parse_knitout(source, say);
  passes::set_stitch_lengths(program, merged(options.stitch_lengths, default_stitch_lengths(program)));
  passes::check_program(program, say);
  std::optional<StitchGraph> graph;
  if (say.error_count() == errors) graph = passes::knit(program, say);
  if (graph) {
    passes::check_graph(*graph, say);
    passes::check_knitting(program, *graph, say);
  }
  if (!graph) graph = passes::knit_all(program);
  if (options.crop.courses || options.crop.needles) {
    graph = passes::crop(*graph, options.crop);
    if (graph->loops.empty())
      say.error(codes::crop_empty, {}, "no loop lies in the courses and on the needles that are wanted",
                "`wale check` without them says how many courses there are");
  }
  return {std::move(program), std::move(*graph)};
}

std::optional<Scene> compile_scene(const Source& source, Sources& sources, Diagnostics& say) {
  auto parsed = parse_scene(source, say);
  if (!parsed) return std::nullopt;
  const Source* pattern = read_pattern(*parsed, sources, say);
  if (!pattern) return std::nullopt;
  auto compiled = compile_chart(*pattern, parsed->overrides, parsed->segments_per_stitch, say);
  if (!compiled) return std::nullopt;

  double diameter = 0;
  for (const Material& yarn : compiled->fabric.materials) diameter = std::max(diameter, yarn.diameter);
  compiled->gauge.thickness = parsed->thickness > 0 ? parsed->thickness : 2 * diameter;
  const Knots ends = secured_ends(compiled->fabric);
  for (Stage& stage : parsed->stages)
    for (EffectSpec& effect : stage.effects)
      if (Knots* knots = std::get_if<Knots>(&effect)) knots->knots = ends.knots;
  return Scene{parsed->name, std::move(compiled->fabric),   std::move(parsed->stages), std::move(compiled->gauge),
               {},           std::move(compiled->crossings)};
}

}  // namespace wale
