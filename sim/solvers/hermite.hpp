/// Cubic Hermite interpolation between the two ends of a step, of order four.
#pragma once

namespace wale {

/// What to multiply the values and the rates at both ends by.
struct HermiteWeights {
  double first = 0, last = 0, first_rate = 0, last_rate = 0;
};

/// At the share `s` of a step of `h` seconds.
inline HermiteWeights hermite(double s, double h) {
  const double r = 1 - s;
  return {r * r * (1 + 2 * s), s * s * (3 - 2 * s), h * s * r * r, -h * s * s * r};
}

/// The same for the rate there: the slope of the interpolation.
inline HermiteWeights hermite_rate(double s, double h) {
  const double r = 1 - s;
  return {-6 * s * r / h, 6 * s * r / h, r * (1 - 3 * s), s * (3 * s - 2)};
}

}  // namespace wale
