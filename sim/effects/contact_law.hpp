/// The three laws by which yarns push each other apart, and their slopes.
#pragma once

#include <limits>

#include "sim/fabric.hpp"
#include "sim/kernels/real.hpp"

namespace wale {

/// By δ, the distance over the contact diameter: f, f'/δ and f'', N/m. With f'/δ in place of f' the barrier needs no
/// square root.
template <class Real>
struct Penalty {
  Real value = 0, slope = 0, second = 0;
};

template <class Real>
[[gnu::always_inline]] inline Penalty<Real> quadratic(double k, const Real& squared) {
  const Real delta = square_root(squared), u = delta - 1;
  return {k * u * u, 2 * k * u / delta, Real(2 * k)};
}

template <class Real>
[[gnu::always_inline]] inline Penalty<Real> barrier(double k, const Real& squared) {
  const Real inverse = 1 / squared, u = 1 - squared;
  return {k * u * u * inverse, 2 * k * (1 - inverse * inverse), 2 * k * (1 + 3 * inverse * inverse)};
}

/// k u^p with u = (1 - δ)/(δ - c), so u' = -(1 - c)/(δ - c)².
template <class Real>
Penalty<Real> core_shell(double k, double core, double p, const Real& squared) {
  const Real infinity = std::numeric_limits<double>::infinity();
  const Real delta = square_root(squared), depth = delta - core;
  const Real u = (1 - delta) / depth, u1 = -(1 - core) / (depth * depth), u2 = -2 * u1 / depth;
  const auto outside = Real(0) < depth;
  const Real power_p = power(select(outside, u, Real(0)), p - 2);
  return {select(outside, Real(k * power_p * u * u), infinity),
          select(outside, Real(k * p * power_p * u * u1 / delta), Real(-infinity)),
          select(outside, Real(k * p * power_p * ((p - 1) * u1 * u1 + u * u2)), infinity)};
}

/// f of δ by its square; zero for δ ≥ 1, where f'' is that of δ = 1. Infinite at δ ≤ 0 for the barrier, at or inside
/// the core for the core-shell law.
template <class Real>
[[gnu::always_inline]] inline Penalty<Real> penalty(const Material& yarn, const Real& squared) {
  const Real clamped = minimum(squared, Real(1));
  switch (yarn.law) {
    case ContactLaw::quadratic:
      return quadratic(yarn.contact_stiffness, clamped);
    case ContactLaw::barrier:
      return barrier(yarn.contact_stiffness, clamped);
    case ContactLaw::core_shell:
      return core_shell(yarn.contact_stiffness, yarn.core_diameter / yarn.diameter, yarn.shell_exponent, clamped);
  }
  return {};
}

/// Two yarns share the push: the mean of both laws.
template <class Real>
[[gnu::always_inline]] inline Penalty<Real> penalty(const Material& a, const Material& b, const Real& squared) {
  const Penalty<Real> p = penalty(a, squared);
  if (&a == &b) return p;
  const Penalty<Real> q = penalty(b, squared);
  return {(p.value + q.value) / 2, (p.slope + q.slope) / 2, (p.second + q.second) / 2};
}

}  // namespace wale
