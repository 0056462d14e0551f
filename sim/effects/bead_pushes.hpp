/// Carries the pushes of touching beads to the control points.
#pragma once

#include <vector>

#include "sim/effects/beads.hpp"

namespace wale {

/// Adds the energy and the forces of all contacts between beads that the materials' contact laws give. `q` are the
/// columns of State::q; `spacing`: of beads on their yarn, by segment, m; `inverse_square`: 1/d² for each of
/// Beads::pairs() with the diameter at which its beads touch, 1/m².
void add_pushes(const Beads&, const Points& q, const std::vector<double>& spacing,
                const std::vector<double>& inverse_square, Load& out);

}  // namespace wale
