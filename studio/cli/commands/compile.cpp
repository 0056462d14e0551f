#include <fmt/core.h>

#include <memory>

#include "sim/results/file.hpp"
#include "studio/cli/commands.hpp"
#include "studio/cli/complain.hpp"
#include "studio/cli/exit_code.hpp"
#include "studio/cli/input.hpp"
#include "studio/cli/knitout_options.hpp"
#include "studio/cli/report.hpp"
#include "studio/cli/yarn_file.hpp"

namespace wale {
namespace {

struct CompileOptions {
  std::string file, out, show, machine;
  std::optional<int> wales;
  KnitoutWords knitout;  // `courses` and `stitch_length` are for charts too
  int segments = 12;
};

/// A chart has a number of courses; nothing, and what is wrong on stderr, if that is not what was asked for.
std::optional<ChartOverrides> overrides(const CompileOptions& options, Sources& sources) {
  const auto read = read_knitout_options(options.knitout, sources);
  if (!read) return std::nullopt;
  const auto& courses = read->crop.courses;
  if (read->crop.needles || (courses && courses->first != courses->last) || !read->stitch_lengths.by_setting.empty() ||
      !options.knitout.plating.empty()) {
    complain("wale compile", "only a knitout file can be cropped, be plated or have several stitch lengths",
             "for a chart give numbers: --courses 20 --stitch-length \"7.23 mm\"");
    return std::nullopt;
  }
  ChartOverrides changes{options.wales, {}, {}, {}};
  if (courses) changes.courses = courses->first;
  if (!options.knitout.stitch_length.empty()) changes.stitch_length = read->stitch_lengths.otherwise;
  return changes;
}

std::string show(const Compiled& compiled, const std::string& noun) {
  if (noun == "program") return print(compiled.program);
  return noun == "graph" ? print(compiled.graph) : print(compiled.arrangement);
}

std::string show(const CompiledChart& compiled, const std::string& noun) {
  return noun == "chart" ? print(compiled.chart) : show(static_cast<const Compiled&>(compiled), noun);
}

/// What a compiled file is asked for; its exit code.
template <class C>
int answer(const std::optional<C>& compiled, const CompileOptions& options, const Diagnostics& say) {
  print_all(say);
  if (!compiled) return bad_input;
  if (!options.show.empty()) fmt::print("{}", show(*compiled, options.show));
  try {
    if (!options.out.empty()) write_yarns(*compiled, options.out);
  } catch (const std::system_error& error) {
    return complain_unwritable(options.out, error);
  }
  return success;
}

bool writes_knitout(const CompileOptions& options) { return options.out.ends_with(".k"); }

int write_knitout(const Program& program, const std::string& path) {
  try {
    write_file(path, print(program));
  } catch (const std::system_error& error) {
    return complain_unwritable(path, error);
  }
  return success;
}

/// A chart as a program for a real machine.
int compile_to_knitout(const Source& source, const ChartOverrides& changes, const CompileOptions& options) {
  const Target* target = find_target(options.machine);
  if (!target)
    return complain("--machine", "no machine is called \"" + options.machine + "\"", "write kniterate or swg");
  Diagnostics say;
  const auto chart = passes::parse_chart(source, changes, say);
  std::optional<Program> program;
  if (chart) program = passes::machine_program(*chart, *target, say);
  print_all(say);
  return program ? write_knitout(*program, options.out) : bad_input;
}

int compile_chart_file(const Source& source, const ChartOverrides& changes, const CompileOptions& options) {
  Diagnostics say;
  const auto compiled = compile_chart(source, changes, options.segments, say);
  return answer(compiled, options, say);
}

int compile_knitout_file(const Source& source, Sources& sources, const CompileOptions& options) {
  const auto wanted = read_knitout_options(options.knitout, sources);
  if (!wanted) return bad_input;
  if (options.show == "chart")
    return complain(source.name, "a knitout file has no chart", "--show program, graph or layout");
  Diagnostics say;
  const bool drawn = options.show == "layout" || (!options.out.empty() && !writes_knitout(options));
  if (drawn) return answer(compile_knitout(source, *wanted, {}, options.segments, say), options, say);
  const Knitted knitted = knit_knitout(source, *wanted, say);
  print_all(say);
  if (say.failed()) return bad_input;
  if (options.show == "program") fmt::print("{}", print(knitted.program));
  if (options.show == "graph") fmt::print("{}", print(knitted.graph));
  return options.out.empty() ? success : write_knitout(knitted.program, options.out);
}

int compile(const CompileOptions& options) {
  if (options.out.empty() && options.show.empty())
    return complain("wale compile", "nothing to do", "give -o OUT or --show chart");
  if (!options.out.empty() && !writes_knitout(options) && !can_write_yarns(options.out)) return bad_input;
  Sources sources;
  const Source* source = read_or_complain(sources, options.file);
  if (!source) return bad_input;
  if (kind_of(*source) == FileKind::knitout) return compile_knitout_file(*source, sources, options);
  const auto changes = overrides(options, sources);
  if (!changes) return bad_input;
  if (!writes_knitout(options)) return compile_chart_file(*source, *changes, options);
  if (!options.show.empty())
    return complain("wale compile", "--show prints what -o OUT.k does not go through", "give one of the two");
  return compile_to_knitout(*source, *changes, options);
}

}  // namespace

void add_compile(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CompileOptions>();
  KnitoutWords& words = options->knitout;
  CLI::App* command =
      app.add_subcommand("compile", "Turns a chart or a knitout file into yarns, or a chart into knitout");
  command->add_option("FILE", options->file, "A chart or a knitout file")->required();
  command->add_option("-o,--out", options->out, "Where to: .h5 (exact), .vtp, .obj, .bcc, .svg, or .k (knitout)");
  command->add_option("--show", options->show, "Print what stands between")
      ->check(CLI::IsMember({"chart", "program", "graph", "layout"}));
  command->add_option("--machine", options->machine, "For -o OUT.k of a chart: kniterate or swg (a Shima SWG)")
      ->default_val("swg");
  command->add_option("--wales", options->wales, "Instead of the chart's");
  command->add_option("--courses", words.courses, "Instead of the chart's; of a knitout file, only these: 5-20");
  command->add_option("--needles", words.needles, "Of a knitout file, only loops made on these: 5-20");
  command->add_option("--stitch-length", words.stitch_length,
                      "\"7.23 mm\" instead of the chart's; for knitout also by setting: \"5 = 9 mm, 6 = 9.5 mm\"");
  add_plating(*command, words);
  command->add_option("--segments", options->segments, "Spline segments a stitch")->check(CLI::Range(8, 200));
  command->callback([options, &exit_code] { exit_code = compile(*options); });
}

}  // namespace wale
