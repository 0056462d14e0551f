/// What a compiled fabric must keep, and where it is gripped: found from its stitch graph and its segments' stitches.
#pragma once

#include <vector>

#include "compiler/arrangement.hpp"
#include "compiler/chart.hpp"
#include "compiler/repeat.hpp"
#include "compiler/stitch_graph.hpp"
#include "sim/scene.hpp"

namespace wale {

/// Both sides of every loop that is pulled through another; at a selvedge only the inner side.
std::vector<Crossing> demanded_crossings(const StitchGraph&, const Arrangement&, const Fabric&);
/// The same without those of dropped loops, which run out of the loops that they were pulled through as the fabric
/// comes to rest.
std::vector<Crossing> lasting_crossings(const StitchGraph&, const Arrangement&, const Fabric&);
/// Of a periodic fabric, both sides of every loop of the repeat: segments of its tile() of repeats_for_crossings each
/// way, in which those loops are the middle ones. The graph is that of the larger piece.
std::vector<Crossing> periodic_crossings(const StitchGraph&, const Arrangement&, const Fabric& tiled, const Repeat&);
/// The tile of a periodic fabric that its crossings refer to, as laid, each segment with the loop of the larger piece
/// that is in its place; -1 where the tile reaches beyond that piece.
Fabric tile_of_loops(const Fabric& periodic, const StitchGraph&, const Repeat&);

/// The ends of a swatch: cast-on and first course, last course and bind-off; the first and the last wale with the yarn
/// that joins courses there. A tube has no course ends.
Gauge gauge_of(const Chart&, const StitchGraph&, const Fabric&);
/// The feet of loops made on empty needles in the first course; the heads of the loops left on needles or, if there are
/// none, those of the last course.
Gauge gauge_of(const StitchGraph&, const Fabric&);

/// Ties both ends of every yarn to the nearest stitch, one contact diameter away.
Knots secured_ends(const Fabric&);

}  // namespace wale
