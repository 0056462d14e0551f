/// The kernels of beads, on one number type of one or four lanes. Each sum is over four lanes, so that it is the same
/// for any number type. They use nothing but that type, so that no other translation unit can share what is compiled
/// here.
#pragma once

#include <limits>

#include "sim/effects/contact_law.hpp"
#include "sim/kernels/bead_kernels.hpp"
#include "sim/kernels/real.hpp"
#include "sim/kernels/vector.hpp"

namespace wale {

template <class Real>
class BeadKernelsOf {
  static constexpr int step = lanes<Real>;
  static_assert(step == 1 || step == row_step);
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  /// One number a bead of a row, or a sum over every fourth one.
  struct Row {
    Real part[row_step / step];
  };

 public:
  static bool locate(const BeadLocating& of, int first, int last) {
    bool near = true;
    for (int segment = first; segment < last; ++segment) near &= locate_row(of, segment);
    return near;
  }

  static double measure(const BeadMeasuring& of, int first, int last) {
    double closest = infinity;
    for (int a = first; a < last; ++a) {
      if (of.rows.count[a] == 4)
        measure_segment<4>(of, a, closest);
      else if (of.rows.count[a] == 3)
        measure_segment<3>(of, a, closest);
      else
        measure_segment<any>(of, a, closest);
    }
    return closest;
  }

  static double push(const BeadPushing& of) {
    Row energy{};
    double* outgoing = of.outgoing;
    for (int begin = 0, end = 0; begin < of.count; begin = end) {
      while (end < of.count && of.contacts[end].a == of.contacts[begin].a) {
        if (end + ahead < of.count) prefetch(of.rows, of.contacts[end + ahead].b);
        ++end;
      }
      push_segment(of, begin, end, outgoing, energy);
    }
    return sum(energy);
  }

  static void spread(const BeadSpreading& of, int first, int last) {
    // Segments four apart share no control point, so that none of them waits for what the one before has stored.
    for (int begin = first; begin < last && begin < first + 4; ++begin)
      for (int segment = begin; segment < last; segment += 4)
        if (of.touched[segment - first]) spread_row(of, segment, of.push + 3 * of.stride * long{segment - first});
  }

 private:
  static bool locate_row(const BeadLocating& of, int segment) {
    const int stride = of.rows.stride;
    const double* weights = of.weights + 5 * static_cast<long>(stride) * of.rows.count[segment];
    const double* q = of.q + 3 * static_cast<long>(of.first_point[segment]);
    const long row = 3 * static_cast<long>(stride) * segment;
    bool near = true;
    for (int j = 0; j < stride; j += step) {
      Vector<Real> y{load<Real>(weights + 4 * stride + j), 0, 0};
      for (int k = 0; k < 4; ++k)
        y +=
            load<Real>(weights + k * stride + j) * Vector<Real>{Real(q[3 * k]), Real(q[3 * k + 1]), Real(q[3 * k + 2])};
      store(y.x, of.at + row + j);
      store(y.y, of.at + row + stride + j);
      store(y.z, of.at + row + 2 * stride + j);
      if (!of.before) continue;
      const Vector<Real> moved = y - vector(of.before + row + j, stride);
      near &= !anywhere<Real>(!(dot(moved, moved) <= of.most_moved));
    }
    return near;
  }

  /// The second segment of a pair lies anywhere; that of the pair so many places on is asked for beforehand.
  static constexpr int ahead = pair_padding;
  static void prefetch(const BeadRows& rows, int segment) {
    const double* row = rows.row(segment);
    __builtin_prefetch(row);
    __builtin_prefetch(row + 2 * rows.stride);
  }

  static Vector<Real> vector(const double* row, long stride) {
    return {load<Real>(row), load<Real>(row + stride), load<Real>(row + 2 * stride)};
  }
  static Vector<Real> one(const double* row, long stride) {
    return {Real(row[0]), Real(row[stride]), Real(row[2 * stride])};
  }

  /// A number of beads that is not known beforehand.
  static constexpr int any = 0;

  /// The pairs of segment a, which has `known` beads.
  template <int known>
  static void measure_segment(const BeadMeasuring& of, int a, double& closest) {
    for (int p = of.first_pair[a]; p < of.first_pair[a + 1]; ++p) {
      const int b = of.partner[p];
      prefetch(of.rows, of.partner[p + ahead]);
      const int materials = of.material[a] * of.materials + of.material[b];
      const double squared =
          of.near_along[p] ? least<known, true>(of, a, b, of.arc_on[p]) : least<known, false>(of, a, b, 0);
      of.squared[p] = squared;
      const double relative = squared * of.inverse_square[materials];
      closest = relative < closest ? relative : closest;
    }
  }

  /// The least squared distance of two beads.
  template <int known, bool screened>
  [[gnu::always_inline]] static double least(const BeadMeasuring& of, int a, int b, double arc_on) {
    const BeadRows& rows = of.rows;
    const int stride = rows.stride, count = known == any ? rows.count[a] : known;
    const double *of_a = rows.row(a), *of_b = rows.row(b, of.image);
    const double screening_length = of.screening_length[of.material[a] * of.materials + of.material[b]];
    const Vector<Real> displacement = one(of.displacement, 1);
    Real nearest = infinity;
    for (int j = 0; j < rows.count[b]; j += step) {
      const Vector<Real> at_b = vector(of_b + j, stride) + displacement;
      for (int i = 0; i < count; ++i) {
        const Vector<Real> apart = one(of_a + i, stride) - at_b;
        Real squared = dot(apart, apart);
        if constexpr (screened)
          squared = select(is_screened(rows, a, i, b, j, arc_on, screening_length), Real(infinity), squared);
        nearest = minimum(nearest, squared);
      }
    }
    return least_of(nearest);
  }

  static auto is_screened(const BeadRows& rows, int a, int i, int b, int j, double arc_on, double screening_length) {
    const Real arc_a = rows.arc[a * static_cast<long>(rows.stride) + i];
    const Real arc_b = load<Real>(rows.arc + b * static_cast<long>(rows.stride) + j);
    return absolute(Real(arc_b + arc_on - arc_a)) < Real(screening_length);
  }

  static double least_of(const Real& x) {
    if constexpr (Pack<Real>)
      return hmin(x);
    else
      return x;
  }

  /// All contacts of segment a.
  static void push_segment(const BeadPushing& of, int begin, int end, double*& outgoing, Row& energy) {
    const long row = 3 * long{of.rows.stride};
    const int a = of.contacts[begin].a;
    // Where their other sides are pushed.
    double* to[most_partners];
    for (int some = begin; some < end; some += most_partners) {
      const int count = end - some < most_partners ? end - some : most_partners;
      for (int c = 0; c < count; ++c) {
        const BeadContact& contact = of.contacts[some + c];
        to[c] = of.push + row * (contact.b - of.first);
        if (contact.b < of.last && contact.image == 0) continue;
        to[c] = outgoing;
        outgoing += row;
        for (int i = 0; i < row; ++i) to[c][i] = 0;
      }
      const Contacts contacts{of, of.contacts + some, to, count};
      double* on_a = of.push + row * (a - of.first);
      for (int i = 0; i < of.rows.count[a]; i += 4) {
        switch (of.rows.count[a] - i) {
          case 1:
            push_beads<1>(contacts, i, on_a, energy);
            break;
          case 2:
            push_beads<2>(contacts, i, on_a, energy);
            break;
          case 3:
            push_beads<3>(contacts, i, on_a, energy);
            break;
          default:
            push_beads<4>(contacts, i, on_a, energy);
        }
      }
    }
  }

  static constexpr int most_partners = 64;
  /// Contacts of one segment a.
  struct Contacts {
    const BeadPushing& push;
    const BeadContact* all;
    double* const* to;
    int count;
  };

  /// `count` beads of segment a, from `first` on.
  template <int count>
  static void push_beads(const Contacts& of, int first, double* on_a, Row& energy) {
    Row total[3 * count];
#pragma GCC unroll 64  // else it becomes a call of memset
    for (Row& row : total)
#pragma GCC unroll 4
      for (Real& part : row.part) part = 0;
    for (int c = 0; c < of.count; ++c) {
      const BeadContact& contact = of.all[c];
      const Material &a = of.push.materials[of.push.material[contact.a]],
                     &b = of.push.materials[of.push.material[contact.b]];
      const double k = a.contact_stiffness;
      if (&a == &b && a.law == ContactLaw::barrier)
        push_pair<count>([k](const Real& u) { return barrier(k, u); }, of.push, contact, first, total, of.to[c],
                         energy);
      else
        push_pair<count>([&](const Real& u) { return penalty(a, b, u); }, of.push, contact, first, total, of.to[c],
                         energy);
    }
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < count; ++i) on_a[c * of.push.rows.stride + first + i] += sum(total[3 * i + c]);
  }

  /// The law is asked about all beads, and answers nothing at the distance of just touching.
  template <int count, class Law>
  [[gnu::always_inline]] static void push_pair(const Law& law, const BeadPushing& pushing, const BeadContact& of,
                                               int first, Row (&total)[3 * count], double* on_b, Row& energy) {
    const BeadRows& rows = pushing.rows;
    const int stride = rows.stride;
    const Vector<Real> displacement = one(pushing.displacements + 3 * of.image, 1);
    const double *row_a = rows.row(of.a) + first, *row_b = rows.row(of.b, pushing.images[of.image]);
    const double inverse_square = 1 / (of.diameter * of.diameter);
    const double scale = -of.weight * inverse_square;
    for (int j = 0; j < rows.count[of.b]; j += step) {
      const int part = j % row_step / step;
      const Vector<Real> at_b = vector(row_b + j, stride) + displacement;
      Vector<Real> sum_b;
      Real value = 0;
      for (int i = 0; i < count; ++i) {
        const Vector<Real> apart = one(row_a + i, stride) - at_b;
        Real squared = dot(apart, apart) * inverse_square;
        if (of.screening_length > 0)
          squared =
              select(is_screened(rows, of.a, first + i, of.b, j, of.arc_on, of.screening_length), Real(1), squared);
        const Penalty<Real> f = law(minimum(squared, Real(1)));
        const Vector<Real> push = Real(scale * f.slope) * apart;
        value += f.value;
        total[3 * i].part[part] += push.x;
        total[3 * i + 1].part[part] += push.y;
        total[3 * i + 2].part[part] += push.z;
        sum_b += push;
      }
      energy.part[part] += of.weight * value;
      subtract(sum_b.x, on_b + j);
      subtract(sum_b.y, on_b + stride + j);
      subtract(sum_b.z, on_b + 2 * stride + j);
    }
  }

  /// On the four control points of a segment, what pushes its beads.
  static void spread_row(const BeadSpreading& of, int segment, const double* push) {
    const double* weights = of.weights + row_step * long{of.stride} * of.count[segment];
    double* force = of.force + (of.first_point[segment] - of.origin);
    for (int k = 0; k < row_step; k += step) {
      Vector<Real> sum = vector(force + k, of.force_stride);
      for (int bead = 0; bead < of.count[segment]; ++bead)
        sum += load<Real>(weights + row_step * bead + k) * one(push + bead, of.stride);
      store(sum.x, force + k);
      store(sum.y, force + of.force_stride + k);
      store(sum.z, force + 2 * of.force_stride + k);
    }
  }

  static void subtract(const Real& x, double* from) { store(Real(load<Real>(from) - x), from); }
  /// (0 + 2) + (1 + 3), as reduce() of four lanes has it.
  static double sum(const Row& row) {
    if constexpr (Pack<Real>)
      return reduce(row.part[0]);
    else
      return (row.part[0] + row.part[2]) + (row.part[1] + row.part[3]);
  }
};

}  // namespace wale
