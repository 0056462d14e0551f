#include "studio/accuracy/report.hpp"
#include "studio/accuracy/sentences.hpp"
#include "studio/accuracy/trial_json.hpp"

namespace wale {
namespace {

using Json = nlohmann::ordered_json;

Json errors_json(const Errors& errors) {
  Json object = Json::object();
  for (std::size_t i = 0; i < readings.size(); ++i) object[std::string(readings[i])] = errors[i];
  return object;
}

Json trial_json(const Trial& trial) {
  Json object = to_json(trial);
  object["rests_elsewhere"] = trial.rests_elsewhere;
  if (!trial.found) return object;
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
