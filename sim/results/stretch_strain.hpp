/// How much each segment of yarn is stretched in a state.
#pragma once

#include <vector>

#include "sim/fabric.hpp"

namespace wale {

/// |y'|/l - 1 in the middle of every segment, where the stretch energy with one node sees it (its other values on a
/// segment alternate about this one). `tightening` says where rest lengths are between Segment::length (0) and
/// Segment::knitted (1).
std::vector<double> stretch_strains(const Fabric&, const Points& q, double tightening);

}  // namespace wale
