/// The flat strip in which a fabric is drawn: x along the courses, y up, z towards the viewer; a tube is wound from it.
#pragma once

#include <cmath>

#include "compiler/curves.hpp"

namespace wale {

/// A flat fabric is the strip itself. For a tube x becomes an angle, z the distance outwards, and the strip climbs.
struct Strip {
  bool tube = false;
  double radius = 0;  ///< of the tube's middle surface, m
  double climb = 0;   ///< dy/dx: one course a turn

  CurvePiece::Point wind(const CurvePiece::Point& p) const {
    if (!tube) return p;
    const double angle = p.y.x() / radius, out = radius + p.y.z(), turn = p.dy.x() / radius;
    const double c = std::cos(angle), s = std::sin(angle);
    return {{out * s, p.y.y() + climb * p.y.x(), out * c},
            {p.dy.z() * s + out * c * turn, p.dy.y() + climb * p.dy.x(), p.dy.z() * c - out * s * turn}};
  }
};

/// A cubic from one point to another with the derivatives given.
inline CurvePiece::Point hermite(const CurvePiece::Point& a, const CurvePiece::Point& b, double u) {
  const double v = 1 - u;
  return {v * v * (1 + 2 * u) * a.y + u * v * v * a.dy + u * u * (1 + 2 * v) * b.y - u * u * v * b.dy,
          6 * u * v * (b.y - a.y) + v * (1 - 3 * u) * a.dy + u * (3 * u - 2) * b.dy};
}

}  // namespace wale
