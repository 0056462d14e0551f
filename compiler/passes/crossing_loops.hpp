/// Cables: which loops change places on their way to the needle where they are knitted, and which passes in front.
#pragma once

#include "compiler/arrangement.hpp"

namespace wale {

/// Sets Hanging::passes. Of two loops that pass each other, the one that is on the front bed then passes in front.
void mark_crossing_loops(const StitchGraph&, Arrangement&);

}  // namespace wale
