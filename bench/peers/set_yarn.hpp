/// Bend of yarn that remembers which way it was bent, for patches whose loops turn little.
#pragma once

#include "sim/parts.hpp"

namespace wale::peers {

/// V = ½ EI l ∫ |K - R K_0|² ds: the curvature vector K = y' × y'' / |y'|³ against that as laid, which the smallest
/// rotation R takes from the tangent as laid to the tangent now. K_0 grows by l0 / l as Bend's does.
///
/// It stands for the rods of other codes, whose resistance to twist keeps the sides of their bends. Turning about its
/// own tangent is held in space and not along the yarn, so it costs energy to turn the patch as a whole: this is no
/// effect for scenes. Its second derivative leaves out the terms with K - R K_0.
std::unique_ptr<Effect> set_yarn(const Parts&);

}  // namespace wale::peers
