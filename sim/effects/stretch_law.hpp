/// ½ EA l (|y'|/l - 1)², Ding et al. 2023, Eq. (12).
#pragma once

#include "sim/kernels/real.hpp"
#include "sim/kernels/site.hpp"

namespace wale {

/// Its constant is EA, N.
struct StretchLaw {
  static constexpr bool elastic = true;
  static constexpr int derivative = 1;

  template <class Real>
  void operator()(const Site<Real>& at, Slope<Real>& slope) const {
    const Real EA = at.constant;
    const Real length = square_root(dot(at.dy, at.dy));
    const Real strain = length / at.l - 1;
    slope.energy = EA * at.l * strain * strain / 2;
    slope.dy = Real(EA * strain / length) * at.dy;
  }
};

}  // namespace wale
