/// What all of a fabric does together, and how neighbours move against each other beside that. `q` and `move` have the
/// columns of State::q.
#pragma once

#include "sim/fabric.hpp"

namespace wale {

/// How far the control point that goes furthest goes, m.
double largest_motion(const Points& from, const Points& to);

/// What of `move` a uniform strain, turn and shift of all of `q` explains, m; a shift alone where strain and turn would
/// be so large that they might bring something to the other side of something else.
Points even_motion(const Points& q, const Points& move);

/// The largest motion of a column of `move` beyond even_motion(), m.
double uneven_motion(const Points& q, const Points& move);

/// The largest motion of a control point beyond a uniform strain, turn and shift of all that it may meet on the way, m:
/// yarns pass through each other only if control points of them differ in it. Never more than uneven_motion(), which is
/// what it is for a periodic fabric.
double uneven_motion_nearby(const Fabric&, const Points& q, const Points& move);

}  // namespace wale
