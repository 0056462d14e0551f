/// A step with two continuous derivatives.
#pragma once

namespace wale {

struct Smooth {
  double value = 0, slope = 0;
};

/// From 0 at u <= 0 to 1 at u >= 1.
constexpr Smooth smooth_step(double u) {
  if (u <= 0) return {0, 0};
  if (u >= 1) return {1, 0};
  return {u * u * u * (10 + u * (-15 + 6 * u)), 30 * u * u * (1 - u) * (1 - u)};
}

}  // namespace wale
