/// Gauss's linking number of closed polylines, exactly; written without the simulator's own counting.
#pragma once

#include "sim/fabric.hpp"

namespace wale::stability {

/// How often `a` winds round `b`; both are closed from their last point to their first (3 x n and 3 x m, m). The sum
/// over all pairs of pieces of the signed solid angle under which one sees the other, over 4π (Arai 2013; Klenin &
/// Langowski 2000, method 1a): a whole number but for rounding, unless the two touch.
double linking_number(const Points& a, const Points& b);

}  // namespace wale::stability
