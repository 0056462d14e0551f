/// From loop to loop along each yarn: how far apart, and what the yarn passes on the way.
#pragma once

#include <vector>

#include "compiler/arrangement.hpp"

namespace wale {

/// Yarn by yarn. What lies between two needles is what hung there when the second loop was made.
std::vector<YarnStep> yarn_steps(const StitchGraph&);

}  // namespace wale
