/// The stress-strain curve as a table in text.
#pragma once

#include <string>

#include "sim/results/results.hpp"

namespace wale {

/// One line a sample of the curve (see strained_rows()), after a line of names with units:
/// `strain,stress_MPa,force_N,force_per_wale_N`, then `residual_N` of a quasi-static stage, and one column
/// `energy_<effect>_J` for every energy that the stage has. Nine significant digits; `nan` where a number lacks.
std::string curve_csv(const Results&);

/// curve_csv() as a file. Throws std::system_error with the path.
void write_csv(const Results&, const std::string& path);

}  // namespace wale
