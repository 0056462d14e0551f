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

std::string show(const CompiledChart& compiled, const std::string& noun) {
  if (noun == "chart") return print(compiled.chart);
  return noun == "program" ? print(compiled.program) : noun == "graph" ? print(compiled.graph) : print(compiled.layout);
}

std::string show(const CompiledKnitout& compiled, const std::string& noun) {
  if (noun == "program") return print(compiled.program);
  return noun == "graph" ? print(compiled.graph) : print(compiled.arrangement);
}

/// What a compiled file is asked for; its exit code.
template <class C>
int answer(const std::optional<C>& compiled, const CompileOptions& options, const Source& source, const Diagnostics& say) {
  print_all(say);
  if (!compiled) return bad_input;
  if (!options.show.empty()) fmt::print("{}", show(*compiled, options.show));
  try {
    if (!options.out.empty()) write_yarns(*compiled, source.name, options.out);
  } catch (const std::system_error& error) {
    return complain_unwritable(options.out, error);
  }
  return success;
}

int compile(const CompileOptions& options) {
  if (options.out.empty() && options.show.empty())
    return complain("wale compile", "nothing to do", "give -o OUT or --show chart");
  if (!options.out.empty() && !can_write_yarns(options.out)) return bad_input;
  Sources sources;
  const Source* source = read_or_complain(sources, options.file);
  if (!source) return bad_input;
  Diagnostics say;
  const ChartOverrides changes = overrides(options, sources, say);
  if (kind_of(*source) != FileKind::knitout) {
    std::optional<CompiledChart> compiled;
    if (!say.failed()) compiled = compile_chart(*source, changes, options.segments, say);
    return answer(compiled, options, *source, say);
  }
  if (options.show == "chart")
    return complain(source->name, "a knitout file has no chart", "--show program, graph or layout");
  std::optional<CompiledKnitout> compiled;
  if (!say.failed()) compiled = compile_knitout(*source, yarn_choice(changes), options.segments, say);
  return answer(compiled, options, *source, say);
}

}  // namespace

void add_compile(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CompileOptions>();
  CLI::App* command = app.add_subcommand("compile", "Turns a chart or a knitout file into yarns");
  command->add_option("FILE", options->file, "A chart or a knitout file")->required();
  command->add_option("-o,--out", options->out, "Where to: .h5 (exact), .vtp, .obj, .bcc or .svg");
  command->add_option("--show", options->show, "Print what stands between")
      ->check(CLI::IsMember({"chart", "program", "graph", "layout"}));
  command->add_option("--wales", options->wales, "Instead of the chart's");
  command->add_option("--courses", options->courses, "Instead of the chart's");
  command->add_option("--stitch-length", options->stitch_length, "Instead of the chart's, as in \"7.23 mm\"");
  command->add_option("--segments", options->segments, "Spline segments a stitch")->check(CLI::Range(8, 200));
  command->callback([options, &exit_code] { exit_code = compile(*options); });
}

}  // namespace wale
