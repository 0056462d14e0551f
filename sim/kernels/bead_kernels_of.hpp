/// The kernels of beads, on one number type of one, four or eight lanes. Each sum is over four beads of b, and over
/// even and odd beads of a, so that it is the same for any number type. They use nothing but that type, so that no
/// other translation unit can share what is compiled here.
#pragma once

#include <limits>

#include "sim/effects/contact_law.hpp"
#include "sim/kernels/bead_kernels.hpp"
#include "sim/kernels/bead_lanes.hpp"
#include "sim/kernels/vector.hpp"

namespace wale {

template <class Real>
class BeadKernelsOf {
  static_assert(lanes<Real> == 1 || lanes<Real> == row_step || lanes<Real> == 2 * row_step);
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr int step = lanes_of_b<Real>, at_once = beads_of_a<Real>;
  /// How many sums over beads b there are to a row, and how many over even or odd beads a.
  static constexpr int parts = row_step / step, sides = 2 / at_once;
  using Single = OfB<Real>;

 public:
  static bool locate(const BeadLocating& of, int first, int last) {
    bool near = true;
    for (int segment = first; segment < last; ++segment) near &= locate_row(of, segment);
    return near;
  }

  static double measure(const BeadMeasuring& of, int first, int last) {
    for (int a = first; a < last; ++a)
      four_at_a_time(of.pairs.rows.count[a], [&]<int count>(int i) { measure_beads<count>(of, a, i); });
    return closest(of, of.pairs.first_pair[first], of.pairs.first_pair[last]);
  }

  static BeadPushed push(const BeadPushing& of) {
    const int count = list_touching(of);
    Energy energy{};
    Outgoing out{of.outgoing, of.outgoing_pair};
    for (int a = of.first, begin = 0, end = 0; begin < count; begin = end) {
      while (of.touching[begin] >= of.pairs.first_pair[a + 1]) ++a;
      const bool plain = is_plain(of, a, of.touching[begin]);
      do {
        if (end + ahead < count) prefetch(of.pairs.rows, of.pairs.partner[of.touching[end + ahead]]);
        ++end;
      } while (end < count && of.touching[end] < of.pairs.first_pair[a + 1] &&
               is_plain(of, a, of.touching[end]) == plain);
      if (plain)
        push_segment<Plain>(of, {a, begin, end}, out, energy);
      else
        push_segment<Any>(of, {a, begin, end}, out, energy);
    }
    return {sum(energy), static_cast<int>(out.pair - of.outgoing_pair)};
  }

  /// Of segments that follow each other on a yarn each adds to three points of the one before, which are kept.
  static void spread(const BeadSpreading& of, int first, int last) {
    Vector<Row<Real>> sum;
    for (int segment = first; segment < last; ++segment) {
      const bool follows = segment > first && of.first_point[segment] == of.first_point[segment - 1] + 1;
      const Vector<Row<Real>> more = spread_row(of, segment, of.push + 3 * of.stride * long{segment - first});
      sum = follows ? Vector<Row<Real>>{moved_up(sum.x), moved_up(sum.y), moved_up(sum.z)} + more : more;
      double* force = of.force + (of.first_point[segment] - of.origin);
      store(sum.x, force);
      store(sum.y, force + of.force_stride);
      store(sum.z, force + 2 * of.force_stride);
    }
  }

 private:
  static bool locate_row(const BeadLocating& of, int segment) {
    const int stride = of.rows.stride;
    const double* weights = of.weights + 5 * static_cast<long>(stride) * of.rows.count[segment];
    const double* q = of.q + 3 * static_cast<long>(of.first_point[segment]);
    const long row = 3 * static_cast<long>(stride) * segment;
    bool near = true;
    for (int j = 0; j < stride; j += step) {
      Vector<Single> y{load<Single>(weights + 4 * stride + j), 0, 0};
      for (int k = 0; k < 4; ++k)
        y += load<Single>(weights + k * stride + j) *
             Vector<Single>{Single(q[3 * k]), Single(q[3 * k + 1]), Single(q[3 * k + 2])};
      store(y.x, of.at + row + j);
      store(y.y, of.at + row + stride + j);
      store(y.z, of.at + row + 2 * stride + j);
      if (!of.before) continue;
      const Vector<Single> moved = y - vector<Single>(of.before + row + j, stride);
      near &= !anywhere<Single>(!(dot(moved, moved) <= of.most_moved));
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

  template <class Number>
  static Vector<Number> vector(const double* row, long stride) {
    return {load<Number>(row), load<Number>(row + stride), load<Number>(row + 2 * stride)};
  }
  static Vector<Real> beads_of_b(const double* row, long stride) {
    return {repeated<Real>(row), repeated<Real>(row + stride), repeated<Real>(row + 2 * stride)};
  }
  static Vector<Real> same(const double* of) { return {Real(of[0]), Real(of[1]), Real(of[2])}; }

  /// Some beads of a segment a. Behind the last one is nowhere, but not where that is behind those of b.
  template <int count>
  struct BeadsOfA {
    static constexpr int groups = (count + at_once - 1) / at_once;
    Vector<Real> at[groups];
    BeadsOfA(const double* row, long stride) {
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

  /// Calls `use` with the first bead of each four, and, as a constant, how many these are.
  template <class Use>
  [[gnu::always_inline]] static void four_at_a_time(int count, const Use& use) {
    for (int first = 0; first < count; first += 4) {
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
    Screen(const BeadPairs& pairs, int pair, int a, int first)
        : arc_a(pairs.rows.arc + static_cast<long>(pairs.rows.stride) * a + first),
          arc_b(pairs.rows.arc + static_cast<long>(pairs.rows.stride) * pairs.partner[pair]),
          arc_on(pairs.arc_on[pair]),
          length(pairs.near_along[pair] ? pairs.screening_length[materials_of(pairs, pair, a)] : 0) {}
    Real operator()(const Real& squared, int i, int j, double instead) const {
      const Real along = repeated<Real>(arc_b + j) + arc_on - each<Real>(arc_a + i);
      return select(absolute(along) < Real(length), Real(instead), squared);
    }
  };
  struct NoScreen {
    Real operator()(const Real& squared, int, int, double) const { return squared; }
  };
  static int materials_of(const BeadPairs& pairs, int pair, int a) {
    return pairs.material[a] * pairs.materials + pairs.material[pairs.partner[pair]];
  }

  /// The pairs of `count` beads of segment a, from `first` on.
  template <int count>
  static void measure_beads(const BeadMeasuring& of, int a, int first) {
    const BeadPairs& pairs = of.pairs;
    const BeadsOfA<count> beads(pairs.rows.row(a) + first, pairs.rows.stride);
    const Vector<Real> displacement = same(pairs.displacement);
    for (int p = pairs.first_pair[a]; p < pairs.first_pair[a + 1]; ++p) {
      prefetch(pairs.rows, pairs.partner[p + ahead]);
      double squared = pairs.near_along[p] ? least(pairs, p, beads, displacement, Screen(pairs, p, a, first))
                                           : least(pairs, p, beads, displacement, NoScreen());
      if (first > 0) squared = minimum(squared, of.squared[p]);
      of.squared[p] = squared;
    }
  }

  /// Of pairs first ... last - 1.
  static double closest(const BeadMeasuring& of, int first, int last) {
    double closest = infinity;
    for (int p = first; p < last; ++p) closest = minimum(closest, of.squared[p] * of.inverse_square[p]);
    return closest;
  }

  /// The least squared distance of two beads.
  template <int count, class Screened>
  [[gnu::always_inline]] static double least(const BeadPairs& pairs, int pair, const BeadsOfA<count>& beads,
                                             const Vector<Real>& displacement, const Screened& screen) {
    const int b = pairs.partner[pair], stride = pairs.rows.stride;
    const double* row = pairs.rows.row(b, pairs.image);
    Real nearest = infinity;
    for (int j = 0; j < pairs.rows.count[b]; j += step) {
      const Vector<Real> at_b = beads_of_b(row + j, stride) + displacement;
#pragma GCC unroll 4
      for (int g = 0; g < beads.groups; ++g) {
        const Vector<Real> apart = beads.at[g] - at_b;
        nearest = minimum(nearest, screen(dot(apart, apart), g * at_once, j, infinity));
      }
    }
    if constexpr (Pack<Real>)
      return hmin(nearest);
    else
      return nearest;
  }

  /// Which pairs touch, in order. A branch would often be taken wrongly.
  static int list_touching(const BeadPushing& of) {
    int count = 0;
    for (int p = of.pairs.first_pair[of.first]; p < of.pairs.first_pair[of.last]; ++p) {
      of.touching[count] = p;
      count += of.squared[p] * of.inverse_square[p] < 1;
    }
    return count;
  }

  /// Segment a, and where those of BeadPushing::touching that are its pairs begin and end.
  struct Contacts {
    int a, begin, end;
  };
  /// Where the next contact that leaves the range pushes b.
  struct Outgoing {
    double* row;
    std::int32_t* pair;
  };
  struct Energy {
    SumsOfB<Real> part[parts];
  };

  /// The law of nearly all contacts: the barrier between beads of one material, none of which is screened.
  struct Plain {
    double stiffness;
    Plain(const BeadPushing& of, int, int a, int) : stiffness(of.materials[of.pairs.material[a]].contact_stiffness) {}
    Penalty<Real> operator()(const Real& squared, int, int) const { return barrier(stiffness, squared); }
  };
  static bool is_plain(const BeadPushing& of, int a, int pair) {
    const BeadPairs& pairs = of.pairs;
    return pairs.material[a] == pairs.material[pairs.partner[pair]] && !pairs.near_along[pair] &&
           of.materials[pairs.material[a]].law == ContactLaw::barrier;
  }
  struct Any {
    const Material &a, &b;
    Screen screen;
    Any(const BeadPushing& of, int pair, int segment, int first)
        : a(of.materials[of.pairs.material[segment]]),
          b(of.materials[of.pairs.material[of.pairs.partner[pair]]]),
          screen(of.pairs, pair, segment, first) {}
    [[gnu::always_inline]] Penalty<Real> operator()(const Real& squared, int i, int j) const {
      return penalty(a, b, screen(squared, i, j, 1));
    }
  };

  template <class Law>
  static void push_segment(const BeadPushing& of, const Contacts& contacts, Outgoing& outgoing, Energy& energy) {
    const Outgoing start = outgoing;
    four_at_a_time(of.pairs.rows.count[contacts.a], [&]<int count>(int first) {
      outgoing = start;
      push_beads<Law, count>(of, contacts, first, outgoing, energy);
    });
  }

  /// `count` beads of segment a, from `first` on.
  template <class Law, int count>
  static void push_beads(const BeadPushing& of, const Contacts& contacts, int first, Outgoing& outgoing,
                         Energy& energy) {
    const int a = contacts.a, stride = of.pairs.rows.stride;
    const BeadsOfA<count> beads(of.pairs.rows.row(a) + first, stride);
    const Vector<Real> displacement = same(of.pairs.displacement);
    Vector<SumsOfA<Real>> total;
    for (int c = contacts.begin; c < contacts.end; ++c) {
      const int p = of.touching[c], b = of.pairs.partner[p];
      const Contact contact{b, of.spacing[a] * of.spacing[b], of.inverse_square[p],
                            row_of_b(of, p, first == 0, outgoing)};
      push_pair(Law(of, p, a, first), of.pairs, contact, beads, displacement, total, energy);
    }
    double* on_a = of.push + 3 * stride * long{a - of.first} + first;
    add(added(total.x), on_a);
    add(added(total.y), on_a + stride);
    add(added(total.z), on_a + 2 * stride);
  }

  static void add(const Row<Real>& row, double* to) { store(load_row<Real>(to) + row, to); }

  /// Where what pushes b is added up.
  static double* row_of_b(const BeadPushing& of, int pair, bool is_new, Outgoing& outgoing) {
    const int row = 3 * of.pairs.rows.stride, b = of.pairs.partner[pair];
    if (b < of.reach) return of.push + row * long{b - of.first};
    double* on_b = outgoing.row;
    if (is_new)
      for (int i = 0; i < row; ++i) on_b[i] = 0;
    *outgoing.pair++ = pair;
    outgoing.row += row;
    return on_b;
  }

  struct Contact {
    int b;
    double weight;          // l_a l_b / (n_a n_b), m² (Ding et al. 2023, Eqs. 17-21 as corrected)
    double inverse_square;  // 1/d², 1/m²
    double* on_b;
  };

  /// The law is asked about all beads, and answers nothing at the distance of just touching.
  template <int count, class Law>
  [[gnu::always_inline]] static void push_pair(const Law& law, const BeadPairs& pairs, const Contact& contact,
                                               const BeadsOfA<count>& beads, const Vector<Real>& displacement,
                                               Vector<SumsOfA<Real>>& total, Energy& energy) {
    const int stride = pairs.rows.stride;
    const double* row = pairs.rows.row(contact.b, pairs.image);
    const double scale = -contact.weight * contact.inverse_square;
    for (int j = 0; j < pairs.rows.count[contact.b]; j += step) {
      const int part = j / step % parts;
      const Vector<Real> at_b = beads_of_b(row + j, stride) + displacement;
      Vector<SumsOfB<Real>> sum_b;
      SumsOfB<Real> value;
#pragma GCC unroll 4
      for (int g = 0; g < beads.groups; ++g) {
        const int side = g % sides;
        const Vector<Real> apart = beads.at[g] - at_b;
        const Real squared = minimum(Real(dot(apart, apart) * contact.inverse_square), Real(1));
        const Penalty<Real> f = law(squared, g * at_once, j);
        const Vector<Real> push = Real(scale * f.slope) * apart;
        value.of[side] += f.value;
        total.x.of[g][part] += push.x;
        total.y.of[g][part] += push.y;
        total.z.of[g][part] += push.z;
        sum_b.x.of[side] += push.x;
        sum_b.y.of[side] += push.y;
        sum_b.z.of[side] += push.z;
      }
#pragma GCC unroll 2
      for (int side = 0; side < sides; ++side) energy.part[part].of[side] += contact.weight * value.of[side];
      subtract(added(sum_b.x), contact.on_b + j);
      subtract(added(sum_b.y), contact.on_b + stride + j);
      subtract(added(sum_b.z), contact.on_b + 2 * stride + j);
    }
  }

  static void subtract(const Single& x, double* from) { store(Single(load<Single>(from) - x), from); }

  static double sum(const Energy& energy) {
    Row<Real> row;
    for (int part = 0; part < parts; ++part) row.part[part] = added(energy.part[part]);
    return wale::sum(row);
  }

  /// On the four control points of a segment, what pushes its beads.
  static Vector<Row<Real>> spread_row(const BeadSpreading& of, int segment, const double* push) {
    const double* weights = of.weights + row_step * long{of.stride} * of.count[segment];
    Vector<Row<Real>> sum;
    for (int bead = 0; bead < of.count[segment]; ++bead) {
      const Row<Real> weight = load_row<Real>(weights + row_step * bead);
      for (int k = 0; k < parts; ++k) {
        sum.x.part[k] += weight.part[k] * push[bead];
        sum.y.part[k] += weight.part[k] * push[of.stride + bead];
        sum.z.part[k] += weight.part[k] * push[2 * of.stride + bead];
      }
    }
    return sum;
  }
};

}  // namespace wale
