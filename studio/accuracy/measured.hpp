/// What a user reads off a run, and by how much two runs differ in it.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "sim/results/curves.hpp"

namespace wale {

/// One run, cut down to what is read off it.
struct Measured {
  std::vector<LabelledCurve> curves{};  ///< stress over strain: of a pull one, of a deformation three
  Features features{};                  ///< of the pull
  Sizes relaxed{};
  double energy = 0;    ///< elastic, of the most strained state, for one stitch, J; NaN if nothing is strained
  Points yarn{};        ///< places on the relaxed yarns, each at the same share of its yarn's length, m
  double diameter = 0;  ///< of the thinnest yarn, m
  bool intact = true;   ///< no yarn has passed through another
};

Measured measured(const Results&);

/// The numbers that errors are given of, as tables call them: of the stress the largest difference over the peak, of
/// the relaxed yarn's position the root mean square over its diameter, of all others over themselves.
inline constexpr std::array<std::string_view, 7> readings{
    "stress", "initial_stiffness", "transition_strain", "course_spacing", "wale_spacing", "energy", "position"};
constexpr std::size_t of_stress = 0, of_course_spacing = 3, of_wale_spacing = 4, of_position = 6;

/// One entry a reading: 0.01 is 1 %. NaN where one of two runs has no such number.
using Errors = std::array<double, readings.size()>;

/// Whether two runs that differ so much rest in different states: their relaxed spacings are more than 5 % apart.
bool rests_apart(const Errors&);

/// Curves are compared at the samples of `run`, by the share of the stage that is done: `fine` may have other samples
/// and is linear between them. Fabrics of other sizes have no common positions.
Errors difference(const Measured& run, const Measured& fine);

}  // namespace wale
