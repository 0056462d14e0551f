/// What lies around some control points.
#pragma once

#include <vector>

#include "sim/fabric.hpp"

namespace wale {

/// The columns of `q` within `reach` of some of them, m, ascending, and others no further than twice that along each
/// axis.
std::vector<int> surroundings(const Points& q, const std::vector<int>& of, double reach);

}  // namespace wale
