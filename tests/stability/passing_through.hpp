/// Whether a yarn has passed through another, told by what no motion without that can change.
#pragma once

#include <optional>
#include <string>

#include "sim/results/results.hpp"
#include "tests/stability/hard_case.hpp"

namespace wale::stability {

/// In words, by comparing all saved states with the first: linking numbers of closed yarns and of the courses of a
/// periodic fabric, the determinant of a knot, and the crossings that the scene demands; nothing if all hold. States
/// must be finite.
std::optional<std::string> passed_through(const HardScene&, const Results&);

/// |Δ(-1)| of a knot's Alexander polynomial, by the crossings of its yarn seen along z: 1 if it opens, 3 for an
/// overhand knot, 9 for a square knot. No end may lie behind or before the knot.
long knot_determinant(const Fabric&, const Points& q);

/// The courses of `up` repeats of a periodic fabric as closed curves: its course period is bent into a circle, by a
/// mapping that lets no curve pass another.
std::vector<Points> bent_round(const Fabric& periodic, const Points& q, int up);

}  // namespace wale::stability
