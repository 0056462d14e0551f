#include "compiler/compile.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/demand.hpp"
#include "compiler/front/scene.hpp"
#include "compiler/jamming.hpp"
#include "compiler/passes/program_codes.hpp"
#include "compiler/passes/tube.hpp"
#include "compiler/spelling.hpp"

namespace wale {
namespace {

/// Contact diameter of the widest yarn that is knitted, m.
double widest_yarn(const StitchGraph& graph, const std::vector<Material>& yarns) {
  double diameter = 0;
  for (const Loop& loop : graph.loops)
    diameter = std::max(diameter, yarns[static_cast<std::size_t>(loop.carrier)].diameter);
  return diameter;
}

/// Of yarn that belongs to no stitch, from end to end, m.
double length_of_floats(const Curves& curves) {
  double length = 0;
  for (const YarnCurve& yarn : curves.yarns)
    for (const CurvePiece& piece : yarn.pieces)
      if (piece.stitch < 0) length += (piece.at(1).y - piece.at(0).y).norm();
  return length;
}

/// A stitch graph as curves.
struct Drawn {
  Arrangement arrangement;
  Curves curves;
};

std::optional<Drawn> draw(const StitchGraph& graph, const std::vector<Material>& yarns, const passes::Edges& edges,
                          Diagnostics& say) {
  const double diameter = widest_yarn(graph, yarns);
  const LoopSize size = large_enough(diameter, longest_stitch(graph));
  Arrangement arrangement = passes::arrange(graph, size, diameter);
  Curves curves = passes::draw(graph, arrangement, size, diameter, edges);
  constexpr double most_wales = 3e5;  // of floats; they cost as much memory as stitches
  if (length_of_floats(curves) > most_wales * size.wale()) {
    say.error(
        codes::floats_too_long, graph.loops.front().span,
        fmt::format("the yarn lies across {:.3g} needles between its stitches", length_of_floats(curves) / size.wale()),
        "leave out what lies far away, with --needles or --courses");
    return std::nullopt;
  }
  return Drawn{std::move(arrangement), std::move(curves)};
}

/// A fabric that knows where each of its stitches is written.
Fabric fit(const Curves& curves, const StitchGraph& graph, const std::vector<Material>& yarns,
           int segments_per_stitch) {
  Fabric fabric = passes::fit(curves, yarns, segments_per_stitch);
  Locator locate_loop;
  for (Segment& segment : fabric.segments) {
    if (segment.stitch < 0) continue;
    const Span& span = graph.loops[static_cast<std::size_t>(segment.stitch)].span;
    if (!span.source) continue;
    const LineColumn place = locate_loop(span);
    segment.line = place.line;
    segment.column = place.column;
    fabric.source = span.source->name;
  }
  return fabric;
}

/// The fabric of a drawing, with every crossing that its graph demands and no other. Its gauge is not known yet.
std::optional<Compiled> proved(std::string name, Program program, StitchGraph graph, const Drawn& drawn,
                               const std::vector<Material>& yarns, int segments_per_stitch, Diagnostics& say) {
  const std::size_t errors = say.error_count();
  Fabric fabric = fit(drawn.curves, graph, yarns, segments_per_stitch);
  auto crossings = demanded_crossings(graph, drawn.arrangement, fabric);
  passes::prove(graph, fabric, crossings, say);
  if (say.error_count() > errors) return std::nullopt;
  const bool drops = std::any_of(graph.loops.begin(), graph.loops.end(), [](const Loop& loop) { return loop.dropped; });
  if (drops) crossings = lasting_crossings(graph, drawn.arrangement, fabric);
  return Compiled{std::move(name), std::move(program),  std::move(graph), drawn.arrangement, std::move(fabric),
                  Gauge{},         std::move(crossings)};
}

std::optional<Knitted> knit_chart(const Chart& chart, Diagnostics& say) {
  auto program = passes::lower_chart(chart, say);
  if (!program) return std::nullopt;
  passes::check_program(*program, say);
  if (say.failed()) return std::nullopt;
  auto graph = passes::knit(*program, say);
  if (!graph) return std::nullopt;
  passes::check_graph(*graph, say);
  if (say.failed()) return std::nullopt;
  return Knitted{std::move(*program), std::move(*graph)};
}

std::optional<CompiledChart> compile_swatch(Chart chart, int segments_per_stitch, Diagnostics& say) {
  auto knitted = knit_chart(chart, say);
  if (!knitted) return std::nullopt;
  const passes::Edges edges{chart.start == Edge::cast_on, chart.end == Edge::bind_off,
                            static_cast<int>(chart.yarns.size())};
  StitchGraph graph = passes::tie_ends(knitted->graph);
  const auto drawn = draw(graph, chart.materials(), edges, say);
  if (!drawn) return std::nullopt;
  auto compiled = proved(chart.name, std::move(knitted->program), std::move(graph), *drawn, chart.materials(),
                         segments_per_stitch, say);
  if (!compiled) return std::nullopt;
  compiled->gauge = gauge_of(chart, compiled->graph, compiled->fabric);
  return CompiledChart{std::move(*compiled), std::move(chart)};
}

/// The larger piece is drawn and proved, the repeat cut out of its middle, and proved once more beside its like.
std::optional<CompiledChart> compile_periodic(Chart chart, int segments_per_stitch, Diagnostics& say) {
  const auto larger = passes::continue_chart(chart, say);
  if (!larger) return std::nullopt;
  auto knitted = knit_chart(larger->chart, say);
  if (!knitted) return std::nullopt;
  const auto drawn = draw(knitted->graph, chart.materials(), {}, say);
  if (!drawn) return std::nullopt;
  auto compiled = proved(chart.name, std::move(knitted->program), std::move(knitted->graph), *drawn, chart.materials(),
                         segments_per_stitch, say);
  if (!compiled) return std::nullopt;
  const StitchGraph& graph = compiled->graph;
  compiled->fabric =
      fit(passes::cut_repeat(drawn->curves, graph, larger->repeat), graph, chart.materials(), segments_per_stitch);
  const Fabric tiled = tile_of_loops(compiled->fabric, graph, larger->repeat);
  compiled->crossings = periodic_crossings(graph, drawn->arrangement, tiled, larger->repeat);
  passes::prove_crossings(graph, tiled, compiled->crossings, say);
  if (say.failed()) return std::nullopt;
  compiled->gauge.wales = chart.wales();
  compiled->gauge.courses = chart.course_count();
  return CompiledChart{std::move(*compiled), std::move(chart)};
}

}  // namespace

std::optional<CompiledChart> compile_chart(const Source& source, const ChartOverrides& overrides,
                                           int segments_per_stitch, Diagnostics& say) {
  auto chart = passes::parse_chart(source, overrides, say);
  if (!chart) return std::nullopt;
  return compile_chart(std::move(*chart), segments_per_stitch, say);
}

std::optional<CompiledChart> compile_chart(Chart chart, int segments_per_stitch, Diagnostics& say) {
  if (chart.periodic) return compile_periodic(std::move(chart), segments_per_stitch, say);
  return compile_swatch(std::move(chart), segments_per_stitch, say);
}

bool holds_knitout(const Source& source) {
  return source.name.ends_with(".k") || source.name.ends_with(".knitout") || source.text.starts_with(";!knitout");
}

Knitted knit_knitout(const Source& source, const KnitoutOptions& options, Diagnostics& say) {
  const std::size_t errors = say.error_count();
  Program program = passes::parse_knitout(source, say);
  program.plating = options.plating;
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

namespace {

/// By carrier, each with a name of its own, since several may hold the same yarn.
std::vector<Material> carrier_materials(const Program& program, const YarnMaterials& given, Diagnostics& say) {
  std::vector<Material> yarns = materials_of(program.carriers, given, default_materials(program), "carrier", say);
  for (std::size_t i = 0; i < yarns.size(); ++i) {
    const std::string& carrier = program.carriers[i];
    yarns[i].name = (yarns[i].name == carrier ? "yarn" : yarns[i].name) + " on " + carrier;
  }
  return yarns;
}

}  // namespace

std::optional<Compiled> compile_knitout(const Source& source, const KnitoutOptions& options, const YarnMaterials& given,
                                        int segments_per_stitch, Diagnostics& say) {
  const std::size_t errors = say.error_count();
  auto [program, graph] = knit_knitout(source, options, say);
  const std::vector<Material> yarns = carrier_materials(program, given, say);
  if (say.error_count() == errors && graph.loops.empty())
    say.error(codes::empty_chart, {&source, 0, 0}, "the program makes no loop, so that there is nothing to draw",
              "bring a carrier in and knit: `in 1`, `knit + f0 1`");
  if (say.error_count() > errors) return std::nullopt;
  warn_of_jamming(graph, yarns, say);
  graph = passes::let_run(graph);
  const auto drawn = draw(graph, yarns, {}, say);
  if (!drawn) return std::nullopt;
  auto compiled = proved(source.name, std::move(program), std::move(graph), *drawn, yarns, segments_per_stitch, say);
  if (compiled) compiled->gauge = gauge_of(compiled->graph, compiled->fabric);
  return compiled;
}

namespace {

struct CompiledPattern {
  Compiled compiled;
  std::vector<std::string> yarns;  // by material
  std::string_view kind;           // what they are called
};

std::optional<CompiledPattern> compile_pattern(const Source& source, const ParsedScene& scene, Diagnostics& say) {
  if (holds_knitout(source)) {
    auto made = compile_knitout(source, scene.knitout, scene.overrides.materials, scene.segments_per_stitch, say);
    if (!made) return std::nullopt;
    std::vector<std::string> carriers = made->program.carriers;
    return CompiledPattern{std::move(*made), std::move(carriers), "carrier"};
  }
  auto made = compile_chart(source, scene.overrides, scene.segments_per_stitch, say);
  if (!made) return std::nullopt;
  std::vector<std::string> names;
  for (const ChartYarn& yarn : made->chart.yarns) names.push_back(yarn.name);
  return CompiledPattern{std::move(*made), std::move(names), "yarn"};
}

/// The place in CompiledPattern::yarns of each yarn that the scene names.
std::vector<int> find_mentioned(const Mentions& mentions, const CompiledPattern& of, Diagnostics& say) {
  if (!mentions.tubes.empty() && !find_tube(of.compiled.graph))
    say.error("S012", mentions.tubes.front(), "there is pressure in a tube only, and this fabric is none",
              "leave it out, or knit a tube: `form: tube` in the chart");
  std::vector<int> places;
  for (const Mentions::Yarn& yarn : mentions.yarns) {
    const auto found = std::find(of.yarns.begin(), of.yarns.end(), yarn.name);
    places.push_back(static_cast<int>(found - of.yarns.begin()));
    if (found == of.yarns.end())
      say.error("S009", yarn.span, fmt::format("the pattern has no {} \"{}\"", of.kind, yarn.name),
                suggest(yarn.name, {of.yarns.begin(), of.yarns.end()}));
  }
  return places;
}

/// `course`: of a knitout file's loop, from 0.
bool holds(const Mentions::Region& region, bool knitout, const Loop& loop, int course) {
  if (!knitout) course = loop.cell.course;
  const std::optional<IntRange>& across = knitout ? region.needles : region.wales;
  const int column = knitout ? loop.needle.index : loop.cell.wale + 1;
  return (!region.courses || region.courses->holds(course + 1)) && (!across || across->holds(column));
}

/// Segments of the stitches in each region that the scene names.
std::vector<std::vector<int>> find_regions(const Mentions& mentions, const CompiledPattern& of, Diagnostics& say) {
  if (mentions.regions.empty()) return {};
  const bool knitout = of.kind == "carrier";
  const Compiled& compiled = of.compiled;
  const std::vector<int> courses = courses_of(compiled.graph);
  std::vector<std::vector<int>> regions;
  for (const Mentions::Region& region : mentions.regions) {
    std::vector<int>& segments = regions.emplace_back();
    for (int i = 0; i < compiled.fabric.segment_count(); ++i) {
      const int stitch = compiled.fabric.segment(i).stitch;
      if (stitch < 0) continue;
      const auto place = static_cast<std::size_t>(stitch);
      if (holds(region, knitout, compiled.graph.loops[place], courses[place])) segments.push_back(i);
    }
    if (compiled.fabric.cell)
      say.error("S013", region.span, "a fabric that repeats has no regions", "leave `courses` and `wales` out");
    else if (knitout ? region.wales.has_value() : region.needles.has_value())
      say.error("S013", region.span,
                fmt::format("a {} has no {}", knitout ? "knitout file" : "chart", knitout ? "wales" : "needles"),
                knitout ? "write `needles: 0-9`" : "write `wales: 1-10`");
    else if (segments.empty())
      say.error("S013", region.span, "there is no stitch in this region",
                knitout ? "`wale check` says how many courses there are, and needles are counted as the file does"
                        : "courses and wales are counted from 1, as `wale compile CHART --show chart` prints them");
  }
  return regions;
}

/// What is known only with the fabric: knots, and which materials and segments effects and stages mean.
void fill_in(Stage& stage, const Knots& ends, const std::vector<int>& places,
             const std::vector<std::vector<int>>& regions) {
  const auto look_up = [&](std::vector<int>& materials) {
    for (int& material : materials) material = places[static_cast<std::size_t>(material)];
  };
  for (Shrink& shrink : stage.shrink) look_up(shrink.materials);
  for (EffectSpec& effect : stage.effects) {
    if (Knots* knots = std::get_if<Knots>(&effect)) knots->knots = ends.knots;
    std::visit(
        [&](auto& spec) {
          if constexpr (requires { spec.materials; }) look_up(spec.materials);
          if constexpr (requires { spec.on; }) {
            look_up(spec.on.materials);
            if (!spec.on.segments.empty()) spec.on.segments = regions[static_cast<std::size_t>(spec.on.segments[0])];
          }
        },
        effect);
  }
}

void change(ParsedScene& scene, const FabricChanges& changes) {
  scene.segments_per_stitch = changes.segments_per_stitch.value_or(scene.segments_per_stitch);
  if (changes.wales) scene.overrides.wales = changes.wales;
  if (changes.courses) scene.overrides.courses = changes.courses;
  scene.overrides.periodic = changes.periodic.value_or(scene.overrides.periodic);
}

}  // namespace

std::optional<Scene> compile_scene(const Source& source, Sources& sources, Diagnostics& say,
                                   const FabricChanges& changes) {
  auto parsed = parse_scene(source, say);
  if (!parsed) return std::nullopt;
  change(*parsed, changes);
  const Source* pattern = read_pattern(*parsed, sources, say);
  if (!pattern || !suits(*parsed, holds_knitout(*pattern), say)) return std::nullopt;
  auto made = compile_pattern(*pattern, *parsed, say);
  if (!made) return std::nullopt;
  const std::size_t errors = say.error_count();
  const std::vector<int> places = find_mentioned(parsed->mentions, *made, say);
  const std::vector<std::vector<int>> regions = find_regions(parsed->mentions, *made, say);
  if (say.error_count() > errors) return std::nullopt;

  Compiled& compiled = made->compiled;
  double diameter = 0;
  for (const Material& yarn : compiled.fabric.materials) diameter = std::max(diameter, yarn.diameter);
  compiled.gauge.thickness = parsed->thickness > 0 ? parsed->thickness : 2 * diameter;
  if (compiled.fabric.cell) compiled.fabric.cell->curls = parsed->curls;
  const Knots ends = secured_ends(compiled.fabric);
  for (Stage& stage : parsed->stages) fill_in(stage, ends, places, regions);
  return Scene{parsed->name,
               parsed->accuracy,
               std::move(compiled.fabric),
               std::move(parsed->stages),
               std::move(compiled.gauge),
               {},
               std::move(compiled.crossings)};
}

}  // namespace wale
