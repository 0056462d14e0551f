/// In which course each loop of a graph is drawn.
#pragma once

#include <vector>

#include "compiler/arrangement.hpp"

namespace wale {

/// Courses by which yarn that is laid over other yarn lies higher.
inline constexpr double over_other = 0.35;

/// Loops through which the same yarn is pulled again before it turns, as in a bind-off.
std::vector<bool> chained_loops(const StitchGraph&, const Arrangement&);

/// How high above the first course each loop's feet lie, in courses. As courses_of(), but a chain along an edge stays
/// in one course, a tuck lies one above the loops that it hangs with, and yarn that is laid over other yarn, as in a
/// cast-on that comes back over itself or that several carriers share, lies a little higher each time. The anchors
/// must have their x and z; yarns further than `apart` from each other in depth, m, do not lie over each other.
std::vector<double> levels_of(const StitchGraph&, const Arrangement&, const std::vector<bool>& chained, double apart);

/// By how many courses each loop lies above its own row: it is pulled through a loop of the same pass that was moved to
/// where the carrier had still to come.
std::vector<int> raised_in_row(const StitchGraph&, const std::vector<bool>& chained);

}  // namespace wale
