/// ½ EI l κ², with κ = |y' × y''| / |y'|³ (Ding et al. 2023, Eqs. 13, 14).
#pragma once

#include "sim/kernels/site.hpp"

namespace wale {

/// Its constant is EI, N m².
struct BendLaw {
  static constexpr bool elastic = true;
  static constexpr int derivative = 2;

  template <class Real>
  void operator()(const Site<Real>& at, Slope<Real>& slope) const {
    const Real half = at.constant * at.l / 2;
    const Vector<Real>&a = at.dy, &b = at.ddy;
    const Real aa = dot(a, a), bb = dot(b, b), ab = dot(a, b);
    const Real area = aa * bb - ab * ab;  // |a × b|²
    const Real p = 1 / aa, p3 = half * p * p * p;
    slope.energy = area * p3;
    // The slopes of the area are 2 (bb a - ab b) by a and 2 (aa b - ab a) by b.
    slope.dy = Real(p3 * (2 * bb - 6 * area * p)) * a - Real(2 * p3 * ab) * b;
    slope.ddy = Real(2 * p3) * (aa * b - ab * a);
  }
};

}  // namespace wale
