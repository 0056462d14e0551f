/// Vectors of space on any number type.
#pragma once

namespace wale {

template <class Real>
struct Vector {
  Real x = 0, y = 0, z = 0;

  // See real.hpp: a call would pass packs through memory.
  [[gnu::always_inline]] Vector& operator+=(const Vector& b) { return *this = *this + b; }
  [[gnu::always_inline]] friend Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  [[gnu::always_inline]] friend Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  [[gnu::always_inline]] friend Vector operator*(const Real& k, const Vector& a) { return {k * a.x, k * a.y, k * a.z}; }
  [[gnu::always_inline]] friend Real dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
};

}  // namespace wale
