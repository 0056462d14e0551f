/// k_o l0 max(0, d/2 - gap)², with the distance of the yarn axis from the surface of a plane, a cylinder or a sphere.
#pragma once

#include "sim/kernels/real.hpp"
#include "sim/kernels/site.hpp"

namespace wale {

/// At one time. Its constant is d/2, m.
struct ObstacleLaw {
  static constexpr bool elastic = true;
  static constexpr int derivative = 0;
  double stiffness;       ///< k_o, N/m²
  Vector<double> centre;  ///< now, m
  Vector<double> axis;
  double radius;  ///< m
  bool flat;      ///< a plane; what lies along the axis counts
  bool endless;   ///< a cylinder: what lies along the axis does not count

  /// Of a point: away from the body, and how far into it the yarn reaches (0: not), m.
  template <class Real>
  struct Touch {
    Vector<Real> away;
    Real depth, distance;  // from the centre, or the axis
  };

  template <class Real>
  Touch<Real> touch(const Site<Real>& at) const {
    const Vector<Real> a{axis.x, axis.y, axis.z};
    Vector<Real> off{at.y.x - centre.x, at.y.y - centre.y, at.y.z - centre.z};
    const Real along = dot(a, off);
    if (flat) return {a, maximum(Real(at.constant - along), Real(0)), along};
    if (endless) off = off - along * a;
    constexpr double least = 1e-30;  // m²: in the very middle no way leads out
    const Real distance = square_root(Real(dot(off, off) + least));
    return {Real(1 / distance) * off, maximum(Real(radius + at.constant - distance), Real(0)), distance};
  }

  template <class Real>
  void operator()(const Site<Real>& at, Slope<Real>& slope) const {
    const Touch<Real> of = touch(at);
    const Real push = 2 * stiffness * at.l0 * of.depth;
    slope.energy = push * of.depth / 2;
    slope.y = Real(-push) * of.away;
  }
};

}  // namespace wale
