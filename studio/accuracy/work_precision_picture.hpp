/// Error over time, both logarithmic: what a unit of accuracy costs.
#pragma once

#include <string>
#include <vector>

#include "studio/accuracy/convergence.hpp"

namespace wale {

struct WorkPrecisionMark {
  WorkPrecision at{};
  std::string label{};
  bool hollow = false;  ///< not to be compared with the others
};

struct WorkPrecisionLine {
  std::string label;
  std::vector<WorkPrecisionMark> marks;
  bool joined = true;
};

/// An SVG picture; marks that are not finite or not positive are left out. The Pareto front of all that are not hollow
/// is drawn as a grey band.
std::string work_precision_svg(const std::vector<WorkPrecisionLine>&, const std::string& title);

}  // namespace wale
