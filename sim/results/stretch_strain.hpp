/// How much each segment of yarn is stretched in a state.
#pragma once

#include <vector>

#include "sim/results/results.hpp"

namespace wale {

/// |y'|/l - 1 in the middle of every segment, where the stretch energy with one node sees it (its other values on a
/// segment alternate about this one). `tightening` says where rest lengths are between Segment::length (0) and
/// Segment::knitted (1).
std::vector<double> stretch_strains(const Fabric&, const Points& q, double tightening);

/// Where rest lengths are in a snapshot, by the stages of its scene; 1 for a scene whose stages are not known.
double tightening_at(const Scene&, const Snapshot&);

}  // namespace wale
