/// k_p l0 max(0, |z| - gap/2)².
#pragma once

#include "sim/kernels/real.hpp"
#include "sim/kernels/site.hpp"

namespace wale {

struct PlatesLaw {
  static constexpr bool elastic = true;
  static constexpr int derivative = 0;
  double stiffness, gap;  ///< k_p, N/m², and m

  template <class Real>
  void operator()(const Site<Real>& at, Slope<Real>& slope) const {
    const Real depth = maximum(Real(absolute(at.y.z) - gap / 2), Real(0));
    const Real push = 2 * stiffness * at.l0 * depth;
    slope.energy = push * depth / 2;
    slope.y.z = select(at.y.z < Real(0), Real(-push), push);
  }
};

}  // namespace wale
