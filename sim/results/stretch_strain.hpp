/// How much each segment of yarn is stretched in a state.
#pragma once

#include <vector>

#include "sim/rest_length.hpp"
#include "sim/results/results.hpp"

namespace wale {

/// |y'|/l - 1 in the middle of every segment, where the stretch energy with one node sees it (its other values on a
/// segment alternate about this one).
std::vector<double> stretch_strains(const Fabric&, const Points& q, const RestLengths&);

/// The rest lengths in a snapshot, by the stages of its scene; those as knitted for a scene whose stages are not known.
RestLengths rest_lengths_at(const Scene&, const Snapshot&);

}  // namespace wale
