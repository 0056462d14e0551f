/// Where the loops of any stitch graph hang from each other, before they are drawn.
#pragma once

#include <string>
#include <vector>

#include "compiler/stitch_graph.hpp"
#include "compiler/strip.hpp"
#include "sim/fabric.hpp"

namespace wale {

/// A point where loops hang from each other: the heads of some, and the feet of those pulled through them. A loop made
/// on an empty needle has its feet at one alone, a loop through which nothing was pulled its head.
struct Anchor {
  Vec3 at = Vec3::Zero();   ///< m, in the strip; x along the courses, y up, z towards the viewer
  Vec3 up = Vec3::UnitY();  ///< unit, in the plane of the fabric: where loops go from here
  std::vector<int> heads;   ///< loops, front to back
  std::vector<int> feet;    ///< loops, front to back
};

/// One loop of an Arrangement.
struct Hanging {
  int feet = -1, head = -1;  ///< indices into Arrangement::anchors
  int via = -1;     ///< where one loop was pulled through it before another was at its head, as in a split; or -1
  int sign = 1;     ///< +1 a knit, -1 a purl, seen from the face: the front, or a tube's outside
  int half = 0;     ///< of a tube: +1 in the half that lay on the front bed, -1 in the other; else 0
  int heading = 1;  ///< +1 drawn from left to right
  bool tucked =
      false;  ///< laid into a hook that held a knitted loop: it hangs behind it, on the far side of the fabric
  bool chained = false;  ///< lies along the edge, as in a bind-off: the next loop of its yarn is pulled through it
  int passes = 0;        ///< +1 if it crosses another loop on its way up and passes in front, -1 if behind
};

/// Yarn on its way in one direction.
struct Leg {
  int side = 1;             ///< +1 to the right
  std::vector<int> passed;  ///< loops between which and the gap of the beds it floats, in the order in which it does
};

/// From one loop of a yarn to the next.
struct YarnStep {
  int from = 0, to = 0;   ///< loops
  bool turns = false;     ///< the yarn goes back
  int apart = 1;          ///< columns
  bool waits = false;     ///< for some courses, in which other yarns were knitted
  std::vector<Leg> legs;  ///< at least one; several where misses led it to and fro
};

/// Of a tube, places are those of its strip.
struct Arrangement {
  Strip strip;
  std::vector<Anchor> anchors;
  std::vector<Hanging> loops;   ///< as StitchGraph::loops
  std::vector<YarnStep> steps;  ///< yarn by yarn
};

/// One loop a line, in millimetres; what `--show layout` prints.
std::string print(const Arrangement&);

}  // namespace wale
