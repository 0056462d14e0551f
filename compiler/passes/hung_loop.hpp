/// The shape of a loop that hangs between any two anchors: the loop of a row, carried along by them.
#pragma once

#include <optional>

#include "compiler/passes/loop_shape.hpp"

namespace wale {

/// How a loop lies at one of its anchors.
struct Footing {
  Vec3 at = Vec3::Zero();      ///< of the anchor, m
  Vec3 up = Vec3::UnitY();     ///< unit, in the plane
  double left = 1, right = 1;  ///< widths of its halves, of a regular loop's
  double depth = 1;            ///< how much deeper than a single loop it reaches: several loops hang here
  double forward = 0;          ///< of its place among them, m
};

/// A loop between its anchors. At its middle height it stands `aside` before (or behind) a loop that it crosses.
struct Bearing {
  Footing feet, head;
  LoopSigns signs;
  double aside = 0;  ///< m
};

/// A loop and those that go on from its feet to the left and right in the same row, if there are such.
struct HungLoop {
  Bearing here;
  std::optional<Bearing> left, right;
};

/// w in [-2, 2], as in loop_point(): feet left and right, head at 0. Where both anchors lie a pitch above each other,
/// and those beside a wale away, it is that loop exactly.
Curve3 hung_point(const LoopSize&, const HungLoop&, double w);

}  // namespace wale
