/// The flat strip in which a fabric is drawn: x along the courses, y up, z towards the viewer; a tube is wound from it.
#pragma once

#include <cmath>
#include <numbers>

#include "compiler/curves.hpp"

namespace wale {

/// A flat fabric is the strip itself. For a tube x becomes an angle and z the distance outwards, and the strip climbs:
/// one course a turn, so that course follows course without a joint.
struct Strip {
  double round = 0;  ///< the tube's circumference, m; 0 for a flat fabric
  double climb = 0;  ///< dy/dx

  bool tube() const { return round > 0; }
  double radius() const { return round / (2 * std::numbers::pi); }

  /// By how many turns a place lies further on along the strip than another, to the nearest.
  double turns_from(double x, double other) const { return tube() ? std::round((x - other) / round) : 0; }

  /// The same place of the tube, where the strip passes it nearest to `x`.
  Vec3 near(double x, const Vec3& at) const {
    const double turns = turns_from(x, at.x());
    return at + turns * round * Vec3(1, -climb, 0);
  }

  CurvePiece::Point wind(const CurvePiece::Point& p) const {
    if (!tube()) return p;
    const double angle = p.y.x() / radius(), out = radius() + p.y.z(), turn = p.dy.x() / radius();
    const double c = std::cos(angle), s = std::sin(angle);
    return {{out * s, p.y.y() + climb * p.y.x(), out * c},
            {p.dy.z() * s + out * c * turn, p.dy.y() + climb * p.dy.x(), p.dy.z() * c - out * s * turn}};
  }
};

}  // namespace wale
