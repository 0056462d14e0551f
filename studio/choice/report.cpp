#include "studio/choice/report.hpp"

#include <nlohmann/json.hpp>

namespace wale {
namespace {

using Json = nlohmann::ordered_json;

Json optional(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json resolution_json(const Settled& settled) {
  if (!settled.resolution) return {};
  const Resolution& of = *settled.resolution;
  return {{"asked", of.asked},
          {"expected_error", of.expected},
          {"scenes", of.scenes},
          {"segments_per_stitch", of.segments_per_stitch},
          {"segments_written", settled.segments_written},
          {"sampling", of.fineness.sampling},
          {"residual_over_load", of.fineness.tolerance},
          {"samples_times", of.samples_times},
          {"refinements", of.refinements}};
}

Json look_json(const SecondLook& look) {
  return {{"segments_per_stitch", look.segments},
          {"estimated_error", optional(look.error)},
          {"of_the_pull_only", look.of_pull_only},
          {"failure", look.failure},
          {"seconds", look.seconds},
          {"seconds_over_those_of_the_run", look.share_of_run}};
}

Json decision_json(const Decision& of) {
  return {{"stage", of.stage_name}, {"effect", of.effect},
          {"in", of.taken},         {"estimate", optional(of.estimate)},
          {"why", of.why},          {"change_seen", optional(of.seen)}};
}

}  // namespace

std::string words_of(const Settled& settled) {
  const std::string settings = settled.resolution ? words_of(*settled.resolution, settled.segments_written) : "";
  return settings + words_of(settled.decisions);
}

std::string choices_json(const Settled& settled, const Refining& refining) {
  Json decisions = Json::array(), looks = Json::array();
  for (const SecondLook& look : refining.looks) looks.push_back(look_json(look));
  Json last;
  if (!looks.empty()) {
    last = looks.back();
    looks.erase(looks.size() - 1);
  }
  for (const Decision& decision : settled.decisions) decisions.push_back(decision_json(decision));
  const Json json{{"accuracy", resolution_json(settled)},
                  {"second_solution", last},
                  {"before_refinement", looks},
                  {"effects", decisions}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace wale
