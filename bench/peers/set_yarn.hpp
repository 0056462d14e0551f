/// Yarn that remembers how it was laid, for patches whose loops turn little.
#pragma once

#include "sim/parts.hpp"

namespace wale::peers {

/// V = ½ EA ∫ (|y'| / u - 1)² u ds + ½ EI ∫ |K - R K_0|² u ds. The speed u is |y'| as laid, times l / l0, so that a
/// coarse spline, which cannot be laid at an even speed, is not stretched within its segments. The curvature vector K =
/// y' × y'' / |y'|³ is held against that as laid, which the smallest rotation R takes from the tangent as laid to the
/// tangent now; K_0 grows by l0 / l as Bend's does.
///
/// It stands for the rods of other codes, whose edges are as long at rest as they were laid, and whose resistance to
/// twist keeps the sides of their bends. Turning about its own tangent is held in space and not along the yarn, so it
/// costs energy to turn the patch as a whole: this is no effect for scenes. The second derivative leaves out the terms
/// with K - R K_0.
std::unique_ptr<Effect> set_yarn(const Parts&);

}  // namespace wale::peers
