/// Fabrics that are knitted in the round: found from how their yarn runs, and unrolled.
#pragma once

#include <optional>
#include <vector>

#include "compiler/arrangement.hpp"

namespace wale {

/// A tube as seen from outside, unrolled: columns count to the right from the first loop made.
struct Tube {
  std::vector<int> side;    ///< by loop: +1 in the half that lies on the front bed, -1 in the other
  std::vector<int> column;  ///< by loop, in [0, round), or (0, round] if the first loop heads to the left
  int round = 0;            ///< columns all the way round
  double per_needle = 1;    ///< columns; 1/2 at half gauge
};

/// A tube that is open at both ends: its yarn goes one way along one half and back along the other, every loop is
/// pulled through loops of its own half, and those wait on their half's bed. Nothing for any other fabric, such as a
/// bag that its cast-on closes; it is drawn as it lies on the needles.
std::optional<Tube> find_tube(const StitchGraph&);

/// Turns what lies in the back half round: it runs the other way there, and shows its knits to the back.
void see_from_outside(const Tube&, Arrangement&);

}  // namespace wale
