/// Where on a fabric a solver got stuck, in words.
#pragma once

#include <string>

#include "sim/world.hpp"

namespace wale {

/// "in stitch 17 of chart.yaml:4:9 (segment 204 of yarn 0)". `column` is of what may move, as Ties counts: a control
/// point or, of a periodic fabric, a period.
std::string whereabouts(const World&, int column);

/// The longest column of `x`, or the first that is not finite.
int worst_column(const Points& x);

}  // namespace wale
