/// What lies about each loop when it is made: how far from the one before, what its yarn passes, what it faces.
#pragma once

#include <vector>

#include "compiler/arrangement.hpp"

namespace wale {

struct Surroundings {
  std::vector<YarnStep> steps;  ///< yarn by yarn
  std::vector<int> across;      ///< by loop: the last loop on the needle across the gap of the beds, or -1
};

/// What hung on the needles when each loop was made. A program's loops must be in the order in which they are made.
Surroundings surroundings(const StitchGraph&);

}  // namespace wale
