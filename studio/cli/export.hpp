/// Yarns as curves for other programs: OBJ polylines and the binary curve collection format.
#pragma once

#include <string>

#include "sim/fabric.hpp"

namespace wale {

/// Wavefront OBJ: one polyline a yarn, four points a segment; metres.
std::string to_obj(const Fabric&, const Points&);

/// Binary curve collection (.bcc, Yuksel's yarn-level models): one open uniform Catmull-Rom curve a yarn, through the
/// ends of its segments; metres, single precision, little endian, y upward.
std::string to_bcc(const Fabric&, const Points&);

}  // namespace wale
