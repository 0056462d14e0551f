/// The bending energy of yarn, with κ = |y' × y''| / |y'|³ (Ding et al. 2023, Eqs. 13, 14).
#pragma once

#include "sim/kernels/real.hpp"
#include "sim/kernels/site.hpp"

namespace wale {

/// ½ EI l κ². Its constant is EI, N m².
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

/// ½ EI l (κ - κ_0)² as a function of u = κ². Its constant is EI, N m²; the x of its reference κ_0 as laid, 1/m.
///
/// (κ - κ_0)² has a corner at κ = 0. With ε = κ_0 / 10, c = √(κ_0² + ε²) and r = √(u + ε²) it becomes
/// u - κ_0² - 2c (r - c): smooth, zero with its slope at κ = κ_0, and exactly κ² for a straight yarn.
struct SetBendLaw {
  static constexpr bool elastic = true;
  static constexpr int derivative = 2;

  /// Of the energy over ½ EI l.
  template <class Real>
  struct ByU {
    Real value, first, second;
  };

  template <class Real>
  static ByU<Real> by_u(const Site<Real>& at, const Real& u) {
    constexpr double rounding = 0.1;
    const Real one = 1, none = 0;
    // A yarn that shrinks keeps its turn from point to point, so that its rest shape shrinks with it.
    const Real rest = at.reference.x * at.l0 / at.l, e = rounding * rest;
    const Real c = square_root(Real(rest * rest + e * e));
    const Real r = select(rest > none, square_root(Real(u + e * e)), one);
    return {u - rest * rest - 2 * c * (r - c), 1 - c / r, c / (2 * r * r * r)};
  }

  template <class Real>
  void operator()(const Site<Real>& at, Slope<Real>& slope) const {
    const Real half = at.constant * at.l / 2;
    const Vector<Real>&a = at.dy, &b = at.ddy;
    const Real aa = dot(a, a), bb = dot(b, b), ab = dot(a, b);
    const Real area = aa * bb - ab * ab, p = 1 / aa, p3 = p * p * p;
    const ByU<Real> of = by_u(at, Real(area * p3));
    const Real weight = half * of.first * p3;
    slope.energy = half * of.value;
    slope.dy = Real(weight * (2 * bb - 6 * area * p)) * a - Real(2 * weight * ab) * b;
    slope.ddy = Real(2 * weight) * (aa * b - ab * a);
  }
};

}  // namespace wale
