/// A quadrature point of a yarn, or of as many segments as a number has lanes, and what a law answers there.
#pragma once

#include "sim/kernels/vector.hpp"

namespace wale {

/// ' is d/ds.
template <class Real>
struct Site {
  Vector<Real> y, dy, ddy, v;  ///< m, m/s
  Real l = 0;                  ///< rest length of the segment now, m
  Real l0 = 0;                 ///< rest length as laid, m
  Real constant = 0;           ///< what the law asked of the material, in its own unit
  Vector<Real> reference;      ///< what the law asked to be kept of this site, in its own unit
};

/// What a law answers, per unit of s: energy and dissipation, and their slopes. Zero at the start.
template <class Real>
struct Slope {
  Real energy = 0, dissipation = 0;
  Vector<Real> y, dy, ddy, v;
};

}  // namespace wale
