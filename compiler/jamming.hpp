/// Whether a yarn is too thick for its stitches.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/diagnostic.hpp"
#include "compiler/stitch_graph.hpp"
#include "sim/fabric.hpp"

namespace wale {

/// A jersey of hard tubes jams where a stitch is so many contact diameters long; see limits.hpp.
bool jams(double stitch_length, const Material& yarn);

/// A warning at `place` that it does.
void warn_of_jamming(double stitch_length, const Material& yarn, std::string_view name, Span place, Diagnostics&);

/// A warning for each carrier of which a loop is too short for its own yarn, at the shortest; `yarns` are by carrier.
/// Loops whose length is not known are passed over.
void warn_of_jamming(const StitchGraph&, const std::vector<Material>& yarns, Diagnostics&);

}  // namespace wale
