/// The cast-on and the bind-off that a chart may ask for: spirals through its first and over its last course.
#pragma once

#include <vector>

#include "compiler/curves.hpp"
#include "compiler/passes/loop_shape.hpp"

namespace wale {

/// One course in the strip, from left to right.
struct EdgeRow {
  struct Place {
    int sign = 1, material = 0;
  };
  std::vector<Place> wales;
  double first = 0;  ///< x of the leftmost loop's middle, m
  double level = 0;  ///< y of the loops' middles, m
  int heading = 1;   ///< +1 if it was knitted from left to right
  int last() const { return static_cast<int>(wales.size()) - 1; }
};

struct EdgeStyle {
  LoopSize size;
  double diameter = 0;       ///< m
  int yarns = 0;             ///< a yarn's edge form is so many materials further: see fit
  CurvePiece::Point stitch;  ///< where the first loop begins, or the last one ends
};

/// Against the first course, and round by a U-turn into it.
std::vector<CurvePiece> cast_on(const EdgeRow& first, const EdgeStyle&);

/// Back over the last course of a flat fabric.
std::vector<CurvePiece> bind_off_flat(const EdgeRow& last, const EdgeStyle&);

/// On in the round over the last course of a tube, which the strip passes a turn further on and a course lower.
std::vector<CurvePiece> bind_off_round(const EdgeRow& last, const EdgeStyle&);

}  // namespace wale
