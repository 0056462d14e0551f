/// Explicit Runge-Kutta methods with an embedded error estimate, as tables of numbers.
#pragma once

#include <string_view>
#include <vector>

#include "sim/scene.hpp"

namespace wale {

/// y1 = y + h Σ b_i k_i, k_i = f(t + c_i h, y + h Σ_{j<i} a_ij k_j). The last stage is evaluated at y1 itself, so it is
/// the first of the next step ("first same as last").
struct Tableau {
  std::string_view name;
  int order = 0;        ///< of y1
  int error_order = 0;  ///< of the embedded solution ŷ1
  std::vector<double> c;
  std::vector<std::vector<double>> a;  ///< row i holds i numbers; the last row is b
  std::vector<double> error;           ///< b - b̂: y1 - ŷ1 = h Σ error_i k_i
  /// Within a step θ²(1 - θ)² h Σ dense_i k_i is added to cubic Hermite interpolation; empty: nothing is.
  std::vector<double> dense{};

  int stages() const { return static_cast<int>(c.size()); }
};

/// Kutta's 3/8 rule of order 4 with a fifth stage for an estimate of order 3 (Ding et al. 2023, A.1; Hairer, Nørsett &
/// Wanner I, II.4).
const Tableau& kutta43();

/// Order 5 with an estimate and a dense output of order 4 (Dormand & Prince 1980; Hairer, Nørsett & Wanner I, II.5 and
/// II.6).
const Tableau& dormand_prince54();

const Tableau& tableau_of(RungeKutta::Method);

}  // namespace wale
