/// The two states of a run that a user looks at first.
#pragma once

#include <optional>

#include "sim/results/results.hpp"

namespace wale {

/// The state that the first stage begins from that mounts, pulls or deforms; the last one if there is none such. Null
/// if nothing is saved.
const Snapshot* relaxed_state(const Results&);
/// Its curvature, 1/m, of a fabric that may curl.
std::optional<double> relaxed_curvature(const Results&);

/// The most strained state of the last stage that pulls or deforms; null if there is none but its start.
const Snapshot* pulled_state(const Results&);

}  // namespace wale
