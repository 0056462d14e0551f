/// The same scene with its yarns in another order.
#pragma once

#include "tests/stability/hard_case.hpp"

namespace wale::stability {

/// The control points that each yarn has, yarn by yarn from the last to the first.
Points last_yarn_first(const Fabric&, const Points& q);

/// The scene with its yarns numbered from the last to the first; segments, points, grips, knots and crossings follow.
/// Not of a periodic fabric.
HardScene renumbered(const HardScene&);

}  // namespace wale::stability
