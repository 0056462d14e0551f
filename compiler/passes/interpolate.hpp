/// The cubic spline through given points, with given end derivatives.
#pragma once

#include "sim/fabric.hpp"

namespace wale {

/// `through`: N + 1 points, one a column; `from` and `to`: the derivatives by s at both ends. Returns N + 3 control
/// points. Solved as a banded system by LAPACK's dgbsv; throws std::runtime_error if LAPACK refuses (it cannot for
/// finite points).
Points interpolate(const Points& through, const Vec3& from, const Vec3& to);

/// The same through n points, n >= 1, and these again after each `period`, without end. Returns n + 3 control points, of
/// which the last three are exactly the first three, one period on.
Points interpolate_periodic(const Points& through, const Vec3& period);

}  // namespace wale
