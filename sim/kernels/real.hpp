/// What the text of a law needs of its number type, which is a double or a pack of them (std::experimental::simd).
#pragma once

#include <cmath>
#include <concepts>
#include <experimental/simd>

namespace wale {

template <class Real>
concept Pack = std::experimental::is_simd_v<Real>;

// A call would pass packs through memory: GCC does not see how short these are.

/// How many doubles a number holds.
template <class Real>
inline constexpr int lanes = 1;
template <Pack Real>
inline constexpr int lanes<Real> = static_cast<int>(Real::size());

template <class Real>
[[gnu::always_inline]] inline Real load(const double* from) {
  if constexpr (Pack<Real>)
    return Real(from, std::experimental::element_aligned);
  else
    return *from;
}

template <class Real>
[[gnu::always_inline]] inline void store(const Real& x, double* to) {
  if constexpr (Pack<Real>)
    x.copy_to(to, std::experimental::element_aligned);
  else
    *to = x;
}

template <class Real>
[[gnu::always_inline]] inline Real square_root(const Real& x) {
  if constexpr (Pack<Real>)
    return std::experimental::sqrt(x);
  else
    return std::sqrt(x);
}

/// `yes` where the condition holds, else `no`.
template <class Condition, class Real>
[[gnu::always_inline]] inline Real select(const Condition& condition, const Real& yes, const Real& no) {
  if constexpr (Pack<Real>) {
    Real chosen = no;
    where(condition, chosen) = yes;
    return chosen;
  } else {
    return condition ? yes : no;
  }
}

template <class Real>
[[gnu::always_inline]] inline Real minimum(const Real& a, const Real& b) {
  if constexpr (Pack<Real>)
    return std::experimental::min(a, b);
  else
    return b < a ? b : a;
}

template <class Real>
[[gnu::always_inline]] inline Real maximum(const Real& a, const Real& b) {
  if constexpr (Pack<Real>)
    return std::experimental::max(a, b);
  else
    return a < b ? b : a;
}

template <class Real>
[[gnu::always_inline]] inline Real absolute(const Real& x) {
  return select(x < Real(0), Real(-x), x);
}

/// x to the `exponent`, x >= 0.
template <class Real>
Real power(const Real& x, double exponent) {
  if constexpr (Pack<Real>)
    return Real([&](auto lane) { return std::pow(static_cast<double>(x[lane]), exponent); });
  else
    return std::pow(x, exponent);
}

/// Whether a condition holds anywhere.
template <class Real, class Condition>
[[gnu::always_inline]] inline bool anywhere(const Condition& condition) {
  if constexpr (Pack<Real>)
    return any_of(condition);
  else
    return condition;
}

}  // namespace wale
