/// D = k_g l |v|² (Ding et al. 2023, Eq. 16, with the factor l); the force is -2 k_g l v.
#pragma once

#include "sim/kernels/site.hpp"

namespace wale {

struct DragLaw {
  static constexpr bool elastic = false;
  static constexpr int derivative = 0;
  double k_g;  ///< kg/(m s)

  template <class Real>
  void operator()(const Site<Real>& at, Slope<Real>& slope) const {
    const Real k = k_g * at.l;
    slope.dissipation = k * dot(at.v, at.v);
    slope.v = Real(2 * k) * at.v;
  }
};

}  // namespace wale
