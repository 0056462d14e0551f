#include "sim/results/summary.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/results/balance.hpp"
#include "sim/results/curves.hpp"
#include "sim/results/file.hpp"
#include "sim/results/moments.hpp"

namespace wale {
namespace {

using Json = nlohmann::ordered_json;

/// A stage is told to pull or to deform by the scene; a file read back has no stages, and then by its name.
bool is_strained(const Scene& scene, const std::string& name) {
  const auto stage =
      std::find_if(scene.stages.begin(), scene.stages.end(), [&](const Stage& each) { return each.name == name; });
  return stage != scene.stages.end() ? stage->strains() : name.starts_with("pull");
}

/// Phases of one name add up: a resumed run has some twice.
Json wall_seconds(const Results& results) {
  double compile = 0, prepare = 0, solve = 0, write = 0;
  Json stages = Json::object();
  for (const Phase& phase : results.phases) {
    if (phase.name == "compile") {
      compile += phase.seconds;
    } else if (phase.name == "write") {
      write += phase.seconds;
    } else {
      (is_strained(results.scene, phase.name) ? solve : prepare) += phase.seconds;
      stages[phase.name] = stages.value(phase.name, 0.0) + phase.seconds;
    }
  }
  return {{"compile", compile},
          {"prepare", prepare},
          {"solve", solve},
          {"write", write},
          {"total", compile + prepare + solve + write},
          {"stages", stages}};
}

Json solver(const Effort& effort) {
  Json json{{"steps", effort.accepted},
            {"rejected", effort.rejected},
            {"retries",
             {{"halved", effort.retries.halved},
              {"continued", effort.retries.continued},
              {"damped", effort.retries.damped},
              {"detoured", effort.retries.detoured}}},
            {"evaluations", effort.evaluations},
            {"factorizations", effort.factorizations}};
  if (effort.spared > 0) json["evaluations_spared"] = effort.spared;
  if (!effort.failure.empty()) json["failure"] = effort.failure;
  return json;
}

Json balance(const Results& results) {
  Json stages = Json::object();
  for (const Balance& stage : balances(results))
    stages[stage.stage] = {
        {"residual_N", stage.residual}, {"tolerance_N", stage.tolerance}, {"residual_over_load", stage.share()}};
  return stages;
}

Json accuracy(const Results& results) {
  const double asked = results.manifest.accuracy;
  return {{"asked", asked > 0 ? Json(asked) : Json()},
          {"estimated_error", results.estimated_error ? Json(*results.estimated_error) : Json()}};
}

Json sizes(const Results& results) {
  const Sizes& relaxed = results.relaxed;
  Json json{{"course_spacing_m", relaxed.course_spacing},
            {"wale_spacing_m", relaxed.wale_spacing},
            {"width_m", relaxed.width},
            {"length_m", relaxed.length},
            {"thickness_m", relaxed.thickness}};
  if (const auto curvature = relaxed_curvature(results)) json["curvature_per_m"] = *curvature;
  return json;
}

Json curve(const Results& results) {
  const Features found = features(stress_strain(results));
  return {{"samples", strained_rows(results.samples).size()},
          {"initial_stiffness_Pa", found.initial_stiffness},
          {"transition_strain", found.transition_strain},
          {"final_stiffness_Pa", found.final_stiffness}};
}

}  // namespace

std::string summary_json(const Results& results) {
  const Fabric& fabric = results.scene.fabric;
  const Manifest& from = results.manifest;
  const Json json{{"version", from.version},
                  {"when", from.when},
                  {"complete", results.complete},
                  {"name", results.scene.name},
                  {"scene_file", from.sources.empty() ? Json() : Json(from.sources.front().name)},
                  {"scene", from.sources.empty() ? Json() : Json(from.sources.front().text)},
                  {"threads", from.threads},
                  {"unknowns", 3 * fabric.points.cols()},
                  {"segments", fabric.segments.size()},
                  {"contact_samples", results.contact_samples},
                  {"wall_seconds", wall_seconds(results)},
                  {"solver", solver(results.effort)},
                  {"balance", balance(results)},
                  {"accuracy", accuracy(results)},
                  {"sizes", sizes(results)},
                  {"curve", curve(results)},
                  {"topology",
                   {{"crossings_expected", results.topology.expected},
                    {"crossings_found", results.topology.found},
                    {"intact", results.topology.intact()}}},
                  {"warnings", results.warnings}};
  // A text that is not UTF-8 is no reason to lose the summary.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_summary(const Results& results, const std::string& path) { write_file(path, summary_json(results)); }

}  // namespace wale
