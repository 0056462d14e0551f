/// A cubic between two points of a curve.
#pragma once

#include "compiler/curves.hpp"

namespace wale {

/// The point at `u` in [0, 1] of the cubic from one point to another with the derivatives given.
inline CurvePiece::Point hermite(const CurvePiece::Point& a, const CurvePiece::Point& b, double u) {
  const double v = 1 - u;
  return {v * v * (1 + 2 * u) * a.y + u * v * v * a.dy + u * u * (1 + 2 * v) * b.y - u * u * v * b.dy,
          6 * u * v * (b.y - a.y) + v * (1 - 3 * u) * a.dy + u * (3 * u - 2) * b.dy};
}

}  // namespace wale
