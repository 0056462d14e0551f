/// The path of every yarn as a smooth curve, before it is cut into segments.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "sim/fabric.hpp"

namespace wale {

/// A smooth piece of a yarn: position and derivative by a parameter on [0, 1].
struct CurvePiece {
  struct Point {
    Vec3 y, dy;
  };
  std::function<Point(double)> at;
  int stitch = -1;  ///< index into StitchGraph::loops; -1 for cast-on, bind-off and joins
  int material = 0;
  double stitch_length = 0;  ///< yarn length that the piece should have in the end, m; 0: shrinks as stitches do
  double shrink = 1;         ///< times so much, where no length is asked for
};

/// Pieces follow each other with continuous position and direction.
struct YarnCurve {
  std::vector<CurvePiece> pieces;
};

struct Curves {
  std::vector<YarnCurve> yarns;
  std::optional<PeriodicCell> cell;  ///< of one repeat of a periodic fabric: every yarn goes on after its course period
};

}  // namespace wale
