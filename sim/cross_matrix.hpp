/// The cross product as a matrix.
#pragma once

#include "sim/fabric.hpp"

namespace wale {

/// cross_matrix(a) b = a × b.
inline Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

}  // namespace wale
