/// The kernels of beads but for pushes, on one number type of one or four lanes.
#pragma once

#include <limits>

#include "sim/kernels/bead_loops.hpp"

namespace wale {

/// `known`: see BeadLoops.
template <class Real, int known>
class BeadKernelsOf : BeadLoops<Real, known> {
  static_assert(lanes<Real> == 1 || lanes<Real> == row_step);
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  using Loops = BeadLoops<Real, known>;
  using Loops::ahead, Loops::end_of, Loops::four_at_a_time, Loops::parts, Loops::prefetch, Loops::same, Loops::step,
      Loops::stride_of, Loops::vector, Loops::beads_of_b;
  using typename Loops::NoScreen, typename Loops::Screen;

 public:
  static bool locate(const BeadLocating& of, int first, int last) {
    auto far = Real(0) != Real(0);
    for (int segment = first; segment < last; ++segment) far = locate_row(of, segment) || far;
    return !anywhere<Real>(far);
  }

  static double measure(const BeadMeasuring& of, int first, int last) {
    const BeadPairs& pairs = of.pairs;
    for (int p = first; p < last; ++p) {
      prefetch(pairs.rows, pairs.b[p + ahead]);
      of.squared[p] = pairs.near_along[p] ? least<Screen>(pairs, p) : least<NoScreen>(pairs, p);
    }
    return closest(of, first, last);
  }

  /// Of segments that follow each other on a yarn each adds to three points of the one before, which are kept.
  static void spread(const BeadSpreading& of, int first, int last) {
    const double* push = of.push;
    ByCoordinate<Row<Real>> sum;
    for (int segment = first; segment < last; ++segment) {
      const bool follows = segment > first && of.first_point[segment] == of.first_point[segment - 1] + 1;
      const ByCoordinate<Row<Real>> more = spread_row(of, of.count[segment], push);
      sum = follows
                ? ByCoordinate<Row<Real>>{moved_up(sum.x) + more.x, moved_up(sum.y) + more.y, moved_up(sum.z) + more.z}
                : more;
      double* force = of.force + (of.first_point[segment] - of.origin);
      store(sum.x, force);
      store(sum.y, force + of.force_stride);
      store(sum.z, force + 2 * of.force_stride);
      push += 3 * stride_of(of.stride);
    }
  }

 private:
  /// Where beads have moved too far.
  [[gnu::always_inline]] static auto locate_row(const BeadLocating& of, int segment) {
    const int stride = stride_of(of.rows.stride);
    const double* weights = of.weights + 5 * static_cast<long>(stride) * of.rows.count[segment];
    const double* q = of.q + 3 * static_cast<long>(of.first_point[segment]);
    const long row = 3 * static_cast<long>(stride) * segment;
    auto far = Real(0) != Real(0);
    for (int j = 0; j < stride; j += step) {
      Vector<Real> y{load<Real>(weights + 4 * stride + j), 0, 0};
      for (int k = 0; k < 4; ++k) y += load<Real>(weights + k * stride + j) * same(q + 3 * k);
      store(y.x, of.at + row + j);
      store(y.y, of.at + row + stride + j);
      store(y.z, of.at + row + 2 * stride + j);
      if (!of.before) continue;
      const Vector<Real> moved = y - vector(of.before + row + j, stride);
      far = far || !(dot(moved, moved) <= of.most_moved);
    }
    return far;
  }

  /// The least squared distance of two beads of a pair.
  template <class Screened>
  [[gnu::always_inline]] static double least(const BeadPairs& pairs, int pair) {
    const Screened screen(pairs, pair);
    const int a = pairs.a[pair], b = pairs.b[pair], stride = stride_of(pairs.rows.stride);
    const double *row_a = pairs.rows.at + 3 * stride * long{a}, *row_b = pairs.image + 3 * stride * long{b};
    const Vector<Real> displacement = same(pairs.displacement);
    Real nearest = infinity;
    four_at_a_time(
        pairs.rows.count[a], [&]<int count>(int first) __attribute__((always_inline)) {
          const typename Loops::template BeadsOfA<count> beads(row_a + first, stride);
          for (int j = 0; j < end_of(pairs.rows.count[b]); j += step) {
            const Vector<Real> at_b = beads_of_b(row_b + j, stride) + displacement;
#pragma GCC unroll 4
            for (int g = 0; g < beads.groups; ++g) {
              const Vector<Real> apart = beads.at[g] - at_b;
              nearest = minimum(nearest, screen(dot(apart, apart), first + g, j, infinity));
            }
          }
        });
    return least_of(nearest);
  }

  static double least_of(const Real& x) {
    if constexpr (Pack<Real>)
      return hmin(x);
    else
      return x;
  }

  static double closest(const BeadMeasuring& of, int first, int last) {
    Real some = infinity;
    int p = first;
    for (; p + lanes<Real> <= last; p += lanes<Real>)
      some = minimum(some, Real(load<Real>(of.squared + p) * load<Real>(of.inverse_square + p)));
    double closest = least_of(some);
    for (; p < last; ++p) closest = minimum(closest, of.squared[p] * of.inverse_square[p]);
    return closest;
  }

  /// On the four control points of a segment, what pushes its beads.
  [[gnu::always_inline]] static ByCoordinate<Row<Real>> spread_row(const BeadSpreading& of, int count,
                                                                   const double* push) {
    const int stride = stride_of(of.stride);
    const double* weights = of.weights + row_step * long{stride} * count;
    ByCoordinate<Row<Real>> sum;
    // Behind the last bead both are zero.
    for (int bead = 0; bead < (known == any_stride ? count : known); ++bead) {
      const Row<Real> weight = load_row<Real>(weights + row_step * bead);
      for (int k = 0; k < parts; ++k) {
        sum.x.part[k] += weight.part[k] * push[bead];
        sum.y.part[k] += weight.part[k] * push[stride + bead];
        sum.z.part[k] += weight.part[k] * push[2 * stride + bead];
      }
    }
    return sum;
  }
};

/// The same for any stride.
template <class Real>
struct AnyBeadKernels {
  template <int known>
  using Of = BeadKernelsOf<Real, known>;
  static bool locate(const BeadLocating& of, int first, int last) {
    return of.rows.stride == row_step ? Of<row_step>::locate(of, first, last) : Of<any_stride>::locate(of, first, last);
  }
  static double measure(const BeadMeasuring& of, int first, int last) {
    return of.pairs.rows.stride == row_step ? Of<row_step>::measure(of, first, last)
                                            : Of<any_stride>::measure(of, first, last);
  }
  static void spread(const BeadSpreading& of, int first, int last) {
    of.stride == row_step ? Of<row_step>::spread(of, first, last) : Of<any_stride>::spread(of, first, last);
  }
};

}  // namespace wale
