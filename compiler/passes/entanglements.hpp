/// Yarn that is drawn through a loop though no stitch asks for it.
#pragma once

#include <vector>

#include "compiler/stitch_graph.hpp"
#include "sim/fabric.hpp"

namespace wale {

struct Entanglement {
  int loop = -1;  ///< of the two loops concerned the one that was made last; a float is of the loop that it leads to
  int with = -1;
};

/// Every half of a loop and every float is held against all loops that it comes near to, but for its neighbours on the
/// yarn and the loops with which it is knitted: they must not clasp. In the order of `loop`.
std::vector<Entanglement> entanglements(const StitchGraph&, const Fabric&);

}  // namespace wale
