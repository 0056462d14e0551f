/// What a run of a study gave, as JSON and back without loss; its errors are not in it, as they are of all runs
/// together.
#pragma once

#include <nlohmann/json.hpp>

#include "studio/accuracy/study.hpp"

namespace wale {

/// Value, cost, and what was found or why nothing was; without places on the yarn. NaN becomes null.
nlohmann::ordered_json to_json(const Trial&);

/// The same with places on the yarn, for trial_from().
nlohmann::ordered_json whole_json(const Trial&);

/// Throws nlohmann::json::exception if that is no whole_json().
Trial trial_from(const nlohmann::ordered_json&);

}  // namespace wale
