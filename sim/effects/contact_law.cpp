#include "sim/effects/contact_law.hpp"

#include <cmath>
#include <limits>

namespace wale {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Penalty quadratic(double k, double delta) {
  const double u = delta - 1;
  return {k * u * u, 2 * k * u, 2 * k};
}

Penalty barrier(double k, double delta) {
  if (delta <= 0) return {infinity, -infinity, infinity};
  const double i2 = 1 / (delta * delta);
  return {k * (i2 + delta * delta - 2), 2 * k * (delta - i2 / delta), 2 * k * (1 + 3 * i2 * i2)};
}

/// k u^p with u = (1 - δ)/(δ - c), so u' = -(1 - c)/(δ - c)².
Penalty core_shell(double k, double core, double p, double delta) {
  const double depth = delta - core;
  if (depth <= 0) return {infinity, -infinity, infinity};
  const double u = (1 - delta) / depth, u1 = -(1 - core) / (depth * depth), u2 = -2 * u1 / depth;
  const double power = std::pow(u, p - 2);
  return {k * power * u * u, k * p * power * u * u1, k * p * power * ((p - 1) * u1 * u1 + u * u2)};
}

}  // namespace

Penalty penalty(const Material& yarn, double delta) {
  if (delta >= 1) return {};
  switch (yarn.law) {
    case ContactLaw::quadratic:
      return quadratic(yarn.contact_stiffness, delta);
    case ContactLaw::barrier:
      return barrier(yarn.contact_stiffness, delta);
    case ContactLaw::core_shell:
      return core_shell(yarn.contact_stiffness, yarn.core_diameter / yarn.diameter, yarn.shell_exponent, delta);
  }
  return {};
}

Penalty penalty(const Material& a, const Material& b, double delta) {
  if (&a == &b) return penalty(a, delta);
  const Penalty p = penalty(a, delta), q = penalty(b, delta);
  return {(p.value + q.value) / 2, (p.first + q.first) / 2, (p.second + q.second) / 2};
}

}  // namespace wale
