/// Quantities with units, as text, to plain SI numbers.
#pragma once

#include <optional>
#include <string_view>

#include "compiler/diagnostic.hpp"

namespace wale {

/// What a number is: its SI unit, and how to speak of it.
struct Dimension {
  std::string_view unit;     ///< SI, as udunits spells it; "1" for a ratio
  std::string_view noun;     ///< "a length"
  std::string_view example;  ///< "7.23 mm"
};

namespace dimensions {
inline constexpr Dimension ratio{"1", "a ratio", "60 %"};
inline constexpr Dimension length{"m", "a length", "7.23 mm"};
inline constexpr Dimension curvature{"1/m", "a curvature", "0.1 1/mm"};
inline constexpr Dimension time{"s", "a time", "2 s"};
inline constexpr Dimension force{"N", "a force", "68.1 N"};
inline constexpr Dimension stress{"Pa", "a pressure", "79 MPa"};
inline constexpr Dimension linear_density{"kg/m", "a linear density", "77 tex"};
inline constexpr Dimension bending_rigidity{"N m2", "a bending rigidity", "1.47e-8 N m^2"};
inline constexpr Dimension torque{"N m", "a torque", "1e-6 N m"};
inline constexpr Dimension stiffness{"N/m", "a stiffness", "100 N/m"};
inline constexpr Dimension foundation{"N/m2", "a stiffness per length", "1e4 N/m^2"};
inline constexpr Dimension spring{"N/m", "a spring stiffness", "100 N/m"};
inline constexpr Dimension acceleration{"m/s2", "an acceleration", "9.81 m/s^2"};
inline constexpr Dimension drag{"kg/m/s", "a drag coefficient", "0.02 kg/(m s)"};
inline constexpr Dimension contact_damping{"N s/m3", "a contact damping", "20 N s/m^3"};
inline constexpr Dimension speed{"m/s", "a speed", "1e-8 m/s"};
}  // namespace dimensions

/// The SI value of `text`, which must be a number and a unit of this dimension (a ratio may stand without a unit).
/// Reports and gives nothing otherwise. Throws std::system_error if the unit database cannot be read.
std::optional<double> parse_quantity(std::string_view text, const Dimension&, Span, Diagnostics&);

}  // namespace wale
