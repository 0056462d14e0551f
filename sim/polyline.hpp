/// Points along the yarns, evenly spaced in the spline parameter.
#pragma once

#include "sim/fabric.hpp"

namespace wale {

/// `per_segment` points on each of the segments [first, last] of one yarn, and the end of the last: 3 x n, m.
/// Throws std::invalid_argument unless the range is one of segments of one yarn and `per_segment` is positive.
Points polyline(const Fabric&, const Points& q, int first, int last, int per_segment);

}  // namespace wale
