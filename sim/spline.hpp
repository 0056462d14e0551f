/// The uniform cubic B-spline on one segment, and Gauss nodes on [0, 1].
#pragma once

#include <array>
#include <cassert>
#include <span>

#include "sim/fabric.hpp"

namespace wale {

/// Weights of the four control points of a segment at parameter s in [0, 1]: value, first and second derivative by s.
struct Basis {
  std::array<double, 4> value, first, second;
};

/// The cubic B-spline of Ding et al. 2023, Eq. (1), as corrected: B(s) = 2/3 - s² + |s|³/2 inside, (2 - |s|)³/6
/// outside.
constexpr Basis basis(double s) {
  const double r = 1 - s;
  return {{r * r * r / 6, 2.0 / 3 - s * s + s * s * s / 2, 2.0 / 3 - r * r + r * r * r / 2, s * s * s / 6},
          {-r * r / 2, -2 * s + 1.5 * s * s, 2 * r - 1.5 * r * r, s * s / 2},
          {r, -2 + 3 * s, -2 + 3 * r, s}};
}

/// Σ weight_k q_(first + k).
template <class Weights>
Vec3 combine(const Points& q, int first, const Weights& weight) {
  return weight[0] * q.col(first) + weight[1] * q.col(first + 1) + weight[2] * q.col(first + 2) +
         weight[3] * q.col(first + 3);
}

struct GaussNode {
  double s = 0, weight = 0;
};

/// Gauss-Legendre nodes on [0, 1]; `count` in 1 ... 5, exact to degree 2 count - 1.
std::span<const GaussNode> gauss(int count);

}  // namespace wale
