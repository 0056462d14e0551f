#include <nlohmann/json.hpp>

#include "studio/accuracy/report.hpp"
#include "studio/accuracy/sentences.hpp"

namespace wale {
namespace {

using Json = nlohmann::ordered_json;

Json errors_json(const Errors& errors) {
  Json object = Json::object();
  for (std::size_t i = 0; i < readings.size(); ++i) object[std::string(readings[i])] = errors[i];
  return object;
}

Json found_json(const Measured& found) {
  Json curves = Json::array();
  for (const LabelledCurve& each : found.curves)
    curves.push_back({{"label", each.label}, {"strain", each.curve.strain}, {"stress_Pa", each.curve.stress}});
  return {{"curves", curves},
          {"initial_stiffness_Pa", found.features.initial_stiffness},
          {"transition_strain", found.features.transition_strain},
          {"course_spacing_m", found.relaxed.course_spacing},
          {"wale_spacing_m", found.relaxed.wale_spacing},
          {"stitch_energy_J", found.energy},
          {"intact", found.intact}};
}

Json trial_json(const Trial& trial) {
  Json object{{"value", trial.label},
              {"size", trial.size},
              {"as_written", trial.as_written},
              {"wall_seconds", trial.cost.wall},
              {"processor_seconds", trial.cost.processor},
              {"evaluations", trial.cost.evaluations},
              {"factorizations", trial.cost.factorizations},
              {"memory_MB", trial.cost.memory},
              {"finds_another_rest", trial.finds_another_rest},
              {"rests_elsewhere", trial.rests_elsewhere}};
  if (!trial.found) {
    object["failure"] = trial.failure;
    return object;
  }
  object["found"] = found_json(*trial.found);
  object["error"] = errors_json(trial.error);
  object["own_error"] = errors_json(trial.own_error);
  return object;
}

Json ladder_json(const Ladder& ladder) {
  Json trials = Json::array();
  for (const Trial& trial : ladder.trials) trials.push_back(trial_json(trial));
  const auto order = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  return {{"knob", ladder.key},
          {"noun", ladder.noun},
          {"kind", ladder.kind == Knob::Kind::choice ? "choice" : "resolution"},
          {"expected_order", order(ladder.expected_order)},
          {"observed_order", order(ladder.observed_order)},
          {"sentence", sentence(ladder)},
          {"trials", trials}};
}

}  // namespace

std::string accuracy_json(const Study& study) {
  Json knobs = Json::array();
  for (const Ladder& ladder : study.ladders) knobs.push_back(ladder_json(ladder));
  const Json json{{"version", WALE_VERSION},
                  {"scene", study.scene},
                  {"complete", study.complete},
                  {"threads", study.threads},
                  {"times", study.times},
                  {"summary", summary_sentence(study)},
                  {"reference", {{"is", study.reference}, {"error", errors_json(study.reference_error)}}},
                  {"knobs", knobs}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace wale
