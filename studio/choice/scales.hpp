/// What the numbers of a scene say before anything is run.
#pragma once

#include <string>

#include "sim/scene.hpp"

namespace wale {

/// Of yarns that make up a tenth of the fabric or more.
struct Scales {
  double stitch_length = 0;   ///< m, knitted yarn in a stitch, the mean
  double diameter = 0;        ///< m, of the thinnest yarn
  double bending_force = 0;   ///< N, EI/d² of the most flexible yarn, the least
  double linear_density = 0;  ///< kg/m, of the heaviest yarn
};

/// Of a fabric compiled with so many segments a stitch.
Scales scales_of(const Fabric&, int segments_per_stitch);

/// One line.
std::string words_of(const Scales&);

/// The largest strain, to either side, that a stage pulls or deforms to; 0 if it does not.
double greatest_strain(const Stage&);
/// How much strain it goes through, there and back.
double strain_path(const Stage&);

}  // namespace wale
