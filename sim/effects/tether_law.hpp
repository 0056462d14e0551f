/// k_t l0 |W (y - F(y_ref, t))|² (Ding et al. 2023, Eq. A.6; the factor l0 keeps it independent of the segment count).
#pragma once

#include "sim/kernels/site.hpp"

namespace wale {

/// At one time. Its reference is y_ref - centre; F = centre + move + scale (y_ref - centre).
struct TetherLaw {
  static constexpr bool elastic = true;
  static constexpr int derivative = 0;
  double stiffness;             ///< k_t, N/m²
  Vector<double> weight;        ///< W², by axis
  Vector<double> scale, place;  ///< now; place: centre + move, m

  template <class Real>
  void operator()(const Site<Real>& at, Slope<Real>& slope) const {
    const Real k = 2 * stiffness * at.l0;
    const Vector<Real> off{at.y.x - (place.x + scale.x * at.reference.x), at.y.y - (place.y + scale.y * at.reference.y),
                           at.y.z - (place.z + scale.z * at.reference.z)};
    slope.y = {k * weight.x * off.x, k * weight.y * off.y, k * weight.z * off.z};
    slope.energy = dot(off, slope.y) / 2;
  }
};

}  // namespace wale
