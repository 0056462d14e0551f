/// Pictures that need no other program: the fabric from the front, the curve, and the curve in a terminal.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/rest_length.hpp"
#include "sim/results/curves.hpp"

namespace wale {

enum class ColourBy : std::uint8_t { material, stretch };

struct PictureOptions {
  std::string title{};
  ColourBy colour_by = ColourBy::material;
  RestLengths rest{1};                             ///< for the strain
  std::optional<std::array<double, 2>> strains{};  ///< ends of the colour scale; else those of this state
  double size = 900;                               ///< the fabric's greater side, px
};

/// The fabric as seen from +z (x to the right, y up), yarns in their true width, what lies nearer over what lies
/// behind. A scale bar in mm; for ColourBy::stretch a colour bar in percent, else the materials' names if several.
std::string fabric_svg(const Fabric&, const Points& q, const PictureOptions&);

/// Stress in MPa over strain in percent; without labels there is no key.
std::string curve_svg(const std::vector<LabelledCurve>&, const std::string& title = "");

/// The same for one curve in 60 x 15 characters and its axes, in UTF-8 (Braille dots); lines end with \n.
std::string terminal_plot(const Curve&);

}  // namespace wale
