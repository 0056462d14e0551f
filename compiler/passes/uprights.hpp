/// Which way is up at each anchor.
#pragma once

#include <vector>

#include "compiler/arrangement.hpp"
#include "compiler/passes/loop_shape.hpp"

namespace wale {

/// Loops stand upright on their row, whichever way they lean; where there is none, as they lean themselves. `raised`:
/// by loop, the courses by which it lies above its row.
void turn_up(Arrangement&, const std::vector<int>& raised, const LoopSize&);

}  // namespace wale
