/// How beads are shared out to the lanes of a number type: one bead of a segment a against one of a segment b, one
/// against four, or two against the same four.
#pragma once

#include "sim/kernels/bead_kernels.hpp"
#include "sim/kernels/real.hpp"

namespace wale {

template <class Real>
inline constexpr int lanes_of_b = lanes<Real> < row_step ? 1 : row_step;
template <class Real>
inline constexpr int beads_of_a = lanes<Real> / lanes_of_b<Real>;

template <class Real>
struct OneSide {
  using type = Real;
};
template <Pack Real>
struct OneSide<Real> {
  using type = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, row_step>>;
};
/// A number for each bead of b that `Real` holds.
template <class Real>
using OfB = typename OneSide<Real>::type;

// std::experimental::simd has no shuffles, and GCC takes its split() and concat() through memory; the compiler's own
// vectors have them.
using FourLanes [[gnu::vector_size(32)]] = double;
using EightLanes [[gnu::vector_size(64)]] = double;

/// One bead of a; with eight lanes another one in the second half.
template <class Real>
[[gnu::always_inline]] inline Real each(double first, double second) {
  if constexpr (beads_of_a<Real> == 2) {
    const Real lane([](auto i) { return static_cast<double>(i); });
    return select(lane < Real(row_step), Real(first), Real(second));
  } else {
    return first;
  }
}
template <class Real>
[[gnu::always_inline]] inline Real each(const double* a) {
  if constexpr (beads_of_a<Real> == 2)
    return each<Real>(a[0], a[1]);
  else
    return a[0];
}

/// The same beads of b for each of a.
template <class Real>
[[gnu::always_inline]] inline Real repeated(const double* b) {
  const auto side = load<OfB<Real>>(b);
  if constexpr (beads_of_a<Real> == 2) {
    const auto four = __builtin_bit_cast(FourLanes, side);
    return __builtin_bit_cast(Real, __builtin_shufflevector(four, four, 0, 1, 2, 3, 0, 1, 2, 3));
  } else {
    return side;
  }
}

/// Four numbers.
template <class Real>
struct Row {
  OfB<Real> part[row_step / lanes_of_b<Real>]{};
};

template <class Real>
[[gnu::always_inline]] inline Row<Real> load_row(const double* from) {
  Row<Real> row;
  for (int i = 0; i < row_step / lanes_of_b<Real>; ++i) row.part[i] = load<OfB<Real>>(from + i * lanes_of_b<Real>);
  return row;
}

template <class Real>
[[gnu::always_inline]] inline void store(const Row<Real>& row, double* to) {
  for (int i = 0; i < row_step / lanes_of_b<Real>; ++i) store(row.part[i], to + i * lanes_of_b<Real>);
}

template <class Real>
[[gnu::always_inline]] inline Row<Real> operator+(Row<Real> a, const Row<Real>& b) {
  for (int i = 0; i < row_step / lanes_of_b<Real>; ++i) a.part[i] += b.part[i];
  return a;
}

/// One for each coordinate.
template <class Sums>
struct ByCoordinate {
  Sums x, y, z;
};

/// A sum for each of four beads of a, over every fourth bead of b.
template <class Real>
struct SumsOfA {
  Real of[row_step / beads_of_a<Real>][row_step / lanes_of_b<Real>]{};
};

/// A sum for each bead of b; one at a time those of even and of odd beads of a, which eight lanes keep apart.
template <class Real>
struct SumsOfB {
  Real of[2 / beads_of_a<Real>]{};
};

template <class Real>
[[gnu::always_inline]] inline OfB<Real> added(const SumsOfB<Real>& sums) {
  if constexpr (beads_of_a<Real> == 2) {
    const auto both = __builtin_bit_cast(EightLanes, sums.of[0]);
    return __builtin_bit_cast(
        OfB<Real>, __builtin_shufflevector(both, both, 0, 1, 2, 3) + __builtin_shufflevector(both, both, 4, 5, 6, 7));
  } else {
    return sums.of[0] + sums.of[1];
  }
}

/// (0 + 1) + (2 + 3)
template <class Real>
[[gnu::always_inline]] inline double sum(const Row<Real>& row) {
  double of[row_step];
  store(row, of);
  return (of[0] + of[1]) + (of[2] + of[3]);
}

/// The sum of each bead of a: (0 + 1) + (2 + 3) of the beads of b.
template <class Real>
[[gnu::always_inline]] inline Row<Real> added(const SumsOfA<Real>& sums) {
  Row<Real> row;
  if constexpr (lanes<Real> == 8) {
    const auto a = __builtin_bit_cast(EightLanes, sums.of[0][0]), b = __builtin_bit_cast(EightLanes, sums.of[1][0]);
    const EightLanes pairs = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14) +
                             __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    row.part[0] = __builtin_bit_cast(OfB<Real>, __builtin_shufflevector(pairs, pairs, 0, 4, 1, 5) +
                                                    __builtin_shufflevector(pairs, pairs, 2, 6, 3, 7));
  } else if constexpr (lanes<Real> == 4) {
    FourLanes of[4], pairs[2];
    for (int i = 0; i < 4; ++i) of[i] = __builtin_bit_cast(FourLanes, sums.of[i][0]);
    for (int i = 0; i < 2; ++i)
      pairs[i] = __builtin_shufflevector(of[2 * i], of[2 * i + 1], 0, 4, 2, 6) +
                 __builtin_shufflevector(of[2 * i], of[2 * i + 1], 1, 5, 3, 7);
    row.part[0] = __builtin_bit_cast(Real, __builtin_shufflevector(pairs[0], pairs[1], 0, 1, 4, 5) +
                                               __builtin_shufflevector(pairs[0], pairs[1], 2, 3, 6, 7));
  } else {
    for (int i = 0; i < 4; ++i) row.part[i] = (sums.of[i][0] + sums.of[i][1]) + (sums.of[i][2] + sums.of[i][3]);
  }
  return row;
}

/// Each number in the place of the one before; zero in the last.
template <class Real>
[[gnu::always_inline]] inline Row<Real> moved_up(const Row<Real>& row) {
  Row<Real> moved;
  if constexpr (Pack<Real>)
    moved.part[0] = __builtin_bit_cast(
        OfB<Real>, __builtin_shufflevector(__builtin_bit_cast(FourLanes, row.part[0]), FourLanes{}, 1, 2, 3, 4));
  else
    for (int i = 0; i < 3; ++i) moved.part[i] = row.part[i + 1];
  return moved;
}

}  // namespace wale
