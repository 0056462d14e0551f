/// What hangs from what: anchors without places.
#pragma once

#include "compiler/arrangement.hpp"

namespace wale {

/// Every loop between its anchors, by the graph alone.
Arrangement hang(const StitchGraph&);

}  // namespace wale
