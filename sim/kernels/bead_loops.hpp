/// What the kernels of beads have in common: how they go through rows and pairs. They use nothing but their number
/// type, so that no other translation unit can share what is compiled here.
#pragma once

#include "sim/kernels/bead_kernels.hpp"
#include "sim/kernels/bead_lanes.hpp"
#include "sim/kernels/vector.hpp"

namespace wale {

/// In place of a stride that is not known beforehand.
inline constexpr int any_stride = 0;

/// `known`: the stride. Nearly always it is row_step, and then most of what loops do is known beforehand.
template <class Real, int known>
class BeadLoops {
 protected:
  static constexpr int step = lanes_of_b<Real>, at_once = beads_of_a<Real>;
  /// How many numbers there are to a row.
  static constexpr int parts = row_step / step;

  static int stride_of(int stride) { return known == any_stride ? stride : known; }
  /// Where to end with the beads of a segment, given how many it has: behind them nothing touches.
  static int end_of(int count) { return known == step ? step : count; }

  /// The second segment of a pair lies anywhere; that of the pair so many places on is asked for beforehand.
  static constexpr int ahead = pair_padding;
  static void prefetch(const BeadRows& rows, int segment) {
    const int stride = stride_of(rows.stride);
    const double* row = rows.at + 3 * stride * long{segment};
    __builtin_prefetch(row);
    __builtin_prefetch(row + 2 * stride);
  }

  [[gnu::always_inline]] static Vector<Real> vector(const double* row, long stride) {
    return {load<Real>(row), load<Real>(row + stride), load<Real>(row + 2 * stride)};
  }
  [[gnu::always_inline]] static Vector<Real> beads_of_b(const double* row, long stride) {
    return {repeated<Real>(row), repeated<Real>(row + stride), repeated<Real>(row + 2 * stride)};
  }
  [[gnu::always_inline]] static Vector<Real> same(const double* of) { return {Real(of[0]), Real(of[1]), Real(of[2])}; }

  /// Some beads of a segment a. Behind the last one is nowhere, but not where that is behind those of b.
  template <int count>
  struct BeadsOfA {
    static constexpr int groups = (count + at_once - 1) / at_once;
    Vector<Real> at[groups];
    [[gnu::always_inline]] BeadsOfA(const double* row, long stride) {
#pragma GCC unroll 4
      for (int g = 0; g < groups; ++g) {
        const int i = g * at_once;
        if (i + at_once <= count)
          at[g] = {each<Real>(row + i), each<Real>(row + stride + i), each<Real>(row + 2 * stride + i)};
        else
          at[g] = {each<Real>(row[i], -nowhere), Real(row[stride + i]), Real(row[2 * stride + i])};
      }
    }
  };

  /// Calls `use` with the first bead of each four, and, as a constant, how many these are. It must be inlined, else
  /// what it adds to would be in memory.
  template <class Use>
  [[gnu::always_inline]] static void four_at_a_time(int count, const Use& use) {
    for (int first = 0; first < (known == any_stride ? count : 1); first += 4) {
      switch (count - first) {
        case 1:
          use.template operator()<1>(first);
          break;
        case 2:
          use.template operator()<2>(first);
          break;
        case 3:
          use.template operator()<3>(first);
          break;
        default:
          use.template operator()<4>(first);
      }
    }
  }

  /// Puts another squared distance where beads of a pair are screened.
  struct Screen {
    const double *arc_a, *arc_b;
    double arc_on, length;
    Screen(const BeadPairs& pairs, int pair)
        : arc_a(pairs.rows.arc + static_cast<long>(pairs.rows.stride) * pairs.a[pair]),
          arc_b(pairs.rows.arc + static_cast<long>(pairs.rows.stride) * pairs.b[pair]),
          arc_on(pairs.arc_on[pair]),
          length(pairs.near_along[pair] ? pairs.screening_length[pairs.material[pairs.a[pair]] * pairs.materials +
                                                                 pairs.material[pairs.b[pair]]]
                                        : 0) {}
    [[gnu::always_inline]] Real operator()(const Real& squared, int i, int j, double instead) const {
      const Real along = repeated<Real>(arc_b + j) + arc_on - each<Real>(arc_a + i);
      return select(absolute(along) < Real(length), Real(instead), squared);
    }
  };
  struct NoScreen {
    NoScreen(const BeadPairs&, int) {}
    Real operator()(const Real& squared, int, int, double) const { return squared; }
  };
};

}  // namespace wale
