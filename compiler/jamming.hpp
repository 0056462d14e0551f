/// Whether a yarn is too thick for its stitches.
#pragma once

#include <string_view>

#include "compiler/diagnostic.hpp"
#include "sim/fabric.hpp"

namespace wale {

/// A jersey of hard tubes jams where a stitch is so many contact diameters long; see limits.hpp.
bool jams(double stitch_length, const Material& yarn);

/// A warning at `place` that it does.
void warn_of_jamming(double stitch_length, const Material& yarn, std::string_view name, Span place, Diagnostics&);

}  // namespace wale
