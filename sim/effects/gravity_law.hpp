/// -rho l0 y·g (Ding et al. 2023, Eq. 15, sign corrected; the mass is that of the yarn as laid).
#pragma once

#include "sim/kernels/site.hpp"

namespace wale {

/// Its constant is rho, kg/m.
struct GravityLaw {
  static constexpr bool elastic = true;
  static constexpr int derivative = 0;
  Vector<double> g;  ///< m/s²

  template <class Real>
  void operator()(const Site<Real>& at, Slope<Real>& slope) const {
    const Real mass = at.constant * at.l0;
    slope.y = {-mass * g.x, -mass * g.y, -mass * g.z};
    slope.energy = dot(at.y, slope.y);
  }
};

}  // namespace wale
