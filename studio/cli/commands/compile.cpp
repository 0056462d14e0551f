#include <fmt/core.h>

#include <memory>

#include "compiler/units.hpp"
#include "studio/cli/commands.hpp"
#include "studio/cli/complain.hpp"
#include "studio/cli/exit_code.hpp"
#include "studio/cli/input.hpp"
#include "studio/cli/report.hpp"
#include "studio/cli/yarn_file.hpp"

namespace wale {
namespace {

struct CompileOptions {
  std::string file, out, show, stitch_length;
  std::optional<int> wales, courses;
  int segments = 12;
};

ChartOverrides overrides(const CompileOptions& options, Sources& sources, Diagnostics& say) {
  ChartOverrides changes{options.wales, options.courses, {}, {}};
  if (!options.stitch_length.empty()) {
    const Source* text = sources.add("--stitch-length", options.stitch_length);
    const Span span{text, 0, static_cast<std::uint32_t>(text->text.size())};
    changes.stitch_length = parse_quantity(text->text, dimensions::length, span, say);
  }
  return changes;
}

std::string show(const Compiled& compiled, const std::string& noun) {
  if (noun == "chart") return print(compiled.chart);
  if (noun == "program") return print(compiled.program);
  if (noun == "graph") return print(compiled.graph);
  return print(compiled.layout);
}

int compile(const CompileOptions& options) {
  if (options.out.empty() && options.show.empty())
    return complain("wale compile", "nothing to do", "give -o OUT or --show chart");
  if (!options.out.empty() && !can_write_yarns(options.out)) return bad_input;
  Sources sources;
  const Source* source = read_or_complain(sources, options.file);
  if (!source || is_knitout(*source)) return bad_input;
  Diagnostics say;
  const ChartOverrides changes = overrides(options, sources, say);
  std::optional<Compiled> compiled;
  if (!say.failed()) compiled = compile_chart(*source, changes, options.segments, say);
  print_all(say);
  if (!compiled) return bad_input;
  if (!options.show.empty()) fmt::print("{}", show(*compiled, options.show));
  try {
    if (!options.out.empty()) write_yarns(*compiled, source->name, options.out);
  } catch (const std::system_error& error) {
    return complain_unwritable(options.out, error);
  }
  return success;
}

}  // namespace

void add_compile(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CompileOptions>();
  CLI::App* command = app.add_subcommand("compile", "Turns a chart into yarns");
  command->add_option("FILE", options->file, "A chart")->required();
  command->add_option("-o,--out", options->out, "Where to: .h5 (exact), .vtp, .obj, .bcc or .svg");
  command->add_option("--show", options->show, "Print what stands between")
      ->check(CLI::IsMember({"chart", "program", "graph", "layout"}));
  command->add_option("--wales", options->wales, "Instead of the chart's");
  command->add_option("--courses", options->courses, "Instead of the chart's");
  command->add_option("--stitch-length", options->stitch_length, "Instead of the chart's, as in \"7.23 mm\"");
  command->add_option("--segments", options->segments, "Spline segments a stitch")->check(CLI::Range(6, 200));
  command->callback([options, &exit_code] { exit_code = compile(*options); });
}

}  // namespace wale
