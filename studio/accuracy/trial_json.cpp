#include "studio/accuracy/trial_json.hpp"

#include <limits>

namespace wale {
namespace {

using Json = nlohmann::ordered_json;

double number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::vector<double> numbers(const Json& json) {
  std::vector<double> values;
  for (const Json& each : json) values.push_back(number(each));
  return values;
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

Measured found_from(const Json& json) {
  Measured found;
  for (const Json& each : json.at("curves")) {
    LabelledCurve curve{each.at("label"), {}};
    curve.curve.strain = numbers(each.at("strain"));
    curve.curve.stress = numbers(each.at("stress_Pa"));
    found.curves.push_back(std::move(curve));
  }
  found.features.initial_stiffness = number(json.at("initial_stiffness_Pa"));
  found.features.transition_strain = number(json.at("transition_strain"));
  found.relaxed.course_spacing = number(json.at("course_spacing_m"));
  found.relaxed.wale_spacing = number(json.at("wale_spacing_m"));
  found.energy = number(json.at("stitch_energy_J"));
  found.intact = json.at("intact");
  found.diameter = number(json.at("diameter_m"));
  const std::vector<double> yarn = numbers(json.at("yarn_m"));
  found.yarn = Eigen::Map<const Points>(yarn.data(), 3, static_cast<Eigen::Index>(yarn.size() / 3));
  return found;
}

}  // namespace

Json to_json(const Trial& trial) {
  Json object{{"value", trial.label},
              {"size", trial.size},
              {"as_written", trial.as_written},
              {"wall_seconds", trial.cost.wall},
              {"processor_seconds", trial.cost.processor},
              {"evaluations", trial.cost.evaluations},
              {"factorizations", trial.cost.factorizations},
              {"memory_MB", trial.cost.memory},
              {"finds_another_rest", trial.finds_another_rest}};
  if (trial.found)
    object["found"] = found_json(*trial.found);
  else
    object["failure"] = trial.failure;
  return object;
}

Json whole_json(const Trial& trial) {
  Json object = to_json(trial);
  if (!trial.found) return object;
  object["found"]["diameter_m"] = trial.found->diameter;
  object["found"]["yarn_m"] =
      std::vector<double>(trial.found->yarn.data(), trial.found->yarn.data() + trial.found->yarn.size());
  return object;
}

Trial trial_from(const Json& json) {
  Trial trial{json.at("value"), json.at("size"), json.at("as_written")};
  trial.cost = {json.at("wall_seconds"), json.at("processor_seconds"), json.at("memory_MB"), json.at("evaluations"),
                json.at("factorizations")};
  trial.finds_another_rest = json.at("finds_another_rest");
  if (json.contains("found"))
    trial.found = found_from(json.at("found"));
  else
    trial.failure = json.at("failure");
  return trial;
}

}  // namespace wale
