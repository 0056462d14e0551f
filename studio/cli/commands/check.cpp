#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "studio/cli/commands.hpp"
#include "studio/cli/exit_code.hpp"
#include "studio/cli/input.hpp"
#include "studio/cli/knitout_options.hpp"
#include "studio/cli/report.hpp"

namespace wale {
namespace {

using Json = nlohmann::ordered_json;

struct CheckOptions {
  std::vector<std::string> files;
  bool json = false, loops = false;
  KnitoutWords knitout;
};

/// Geometry is laid too, since what cannot exist is found there; the fewest segments suffice.
constexpr int segments_per_stitch = 6;

Json check_source(const Source& source, Sources& sources, const KnitoutOptions& options, bool loops, Diagnostics& say) {
  Json report = {{"file", source.name}, {"kind", name_of(kind_of(source))}};
  if (kind_of(source) == FileKind::scene) {
    const std::optional<Scene> scene = compile_scene(source, sources, say);
    if (scene) report.update(Json{{"stages", scene->stages.size()}, {"segments", scene->fabric.segments.size()}});
  } else if (kind_of(source) == FileKind::knitout) {
    const Knitted knitted = knit_knitout(source, options, say);
    report.update(counts(knitted.program, knitted.graph));
    if (loops) report["loop_list"] = loops_json(knitted.program, knitted.graph);
  } else if (const auto compiled = compile_chart(source, {}, segments_per_stitch, say)) {
    report.update(counts(compiled->program, compiled->graph));
    report["courses"] = compiled->chart.course_count();
    report["wales"] = compiled->chart.wales();
    if (loops) report["loop_list"] = loops_json(compiled->program, compiled->graph);
  }
  report["diagnostics"] = to_json(say);
  return report;
}

void print_summary(const Json& report) {
  if (report.contains("loops"))
    fmt::print("{}: {} courses x {} wales, {} loops\n", report["file"].get<std::string>(), report["courses"].get<int>(),
               report["wales"].get<int>(), report["loops"].get<int>());
  else
    fmt::print("{}: {} stages, {} segments\n", report["file"].get<std::string>(), report["stages"].get<int>(),
               report["segments"].get<int>());
}

int check(const CheckOptions& options) {
  int worst = success;
  Json reports = Json::array();
  for (const std::string& path : options.files) {
    Sources sources;
    Diagnostics say;
    const auto knitout = read_knitout_options(options.knitout, sources);
    if (!knitout) return bad_input;
    const Source* source = read_or_complain(sources, path);
    reports.push_back(source ? check_source(*source, sources, *knitout, options.loops, say)
                             : Json{{"file", path}, {"readable", false}});
    print_all(say);
    const bool good = source && !say.failed();
    if (good && !options.json) print_summary(reports.back());
    worst = std::max(worst, good ? success : bad_input);
  }
  if (options.json) fmt::print("{}", dump((reports.size() == 1 ? reports[0] : Json{{"files", reports}})));
  return worst;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command =
      app.add_subcommand("check", "Says what is wrong with charts, scenes and knitout files; writes nothing");
  command->add_option("FILE", options->files, "Charts, scenes or knitout files")->required();
  command->add_flag("--json", options->json, "Print one JSON object");
  command->add_flag("--loops", options->loops, "With --json: list every loop too");
  command->add_option("--courses", options->knitout.courses, "Of a knitout file, only these: 5-20");
  command->add_option("--needles", options->knitout.needles, "Of a knitout file, only loops made on these: 5-20");
  add_plating(*command, options->knitout);
  command->callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace wale
