#include "compiler/compile.hpp"

#include "compiler/demand.hpp"

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
  return Compiled{std::move(chart), std::move(*program), std::move(*graph), std::move(*layout),
                  std::move(*fabric), std::move(gauge),  std::move(crossings)};
}

}  // namespace wale
