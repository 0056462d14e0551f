/// Several repeats of a periodic fabric side by side, as a plain one: for pictures, and to follow its crossings.
#pragma once

#include "sim/fabric.hpp"

namespace wale {

/// The control points of a periodic fabric as the compiler laid them, and after them its two periods, course and wale:
/// 3 x (M + 2), m.
Points points_and_periods(const Fabric& periodic);

/// `across` x `up` repeats as a plain fabric: every yarn `across` times as long, the yarns of the lowest repeats first,
/// those of one in their own order. The lower left repeat lies where `q` has it; segments and stitches are as in the
/// repeat. `q` is as points_and_periods(): the M control points of the repeat, the course period, the wale period, m.
/// Throws std::invalid_argument unless the fabric is periodic, `q` has M + 2 columns and both counts are positive.
Fabric tile(const Fabric& periodic, const Points& q, int across, int up);

/// The segment of a tile() of `across` repeats a row that is `segment` of the repeat `to_right` places to the right of
/// the lower left one, and `above` places above it.
int tile_segment(const Fabric& periodic, int segment, int across, int to_right, int above);

/// Crossings of a periodic fabric are segments of its tile() of so many repeats each way; the loops pulled through
/// others are those of the one in the middle.
inline constexpr int repeats_for_crossings = 3;

}  // namespace wale
