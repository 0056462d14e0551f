/// The kernel that pushes beads, on one number type of one, four or eight lanes. Each sum is over four beads of b, and
/// over even and odd beads of a, so that it is the same for any number type.
#pragma once

#include "sim/effects/contact_law.hpp"
#include "sim/kernels/bead_loops.hpp"

namespace wale {

/// `known`: see BeadLoops.
template <class Real, int known>
class BeadPushKernel : BeadLoops<Real, known> {
  static_assert(lanes<Real> == 1 || lanes<Real> == row_step || lanes<Real> == 2 * row_step);
  using Loops = BeadLoops<Real, known>;
  using Loops::ahead, Loops::at_once, Loops::beads_of_b, Loops::end_of, Loops::four_at_a_time, Loops::parts,
      Loops::prefetch, Loops::same, Loops::step, Loops::stride_of;
  using typename Loops::Screen;
  using Single = OfB<Real>;
  /// How many sums over even or odd beads a there are.
  static constexpr int sides = 2 / at_once;

 public:
  static BeadPushed push(const BeadPushing& of, int first, int last) {
    Energy energy{};
    Outgoing out{of.outgoing, of.outgoing_pair};
    std::int32_t *plain = of.touching, *other = plain + (last - first);
    const Counts touching = list_touching(of, first, last, plain, other);
    for (int c = 0; c < touching.plain; ++c) {
      if (c + ahead < touching.plain) prefetch(of.pairs.rows, of.pairs.b[plain[c + ahead]]);
      push_pair<Plain>(of, plain[c], out, energy);
    }
    for (int c = 0; c < touching.other; ++c) push_pair<Any>(of, other[c], out, energy);
    return {sum(energy), static_cast<int>(out.pair - of.outgoing_pair)};
  }

 private:
  struct Counts {
    int plain, other;
  };
  /// Which pairs touch, in order, and apart from others those that Plain holds for. A branch would often be taken
  /// wrongly.
  static Counts list_touching(const BeadPushing& of, int first, int last, std::int32_t* plain, std::int32_t* other) {
    const BeadPairs& pairs = of.pairs;
    Counts counts{0, 0};
    for (int p = first; p < last; ++p) {
      const int material = pairs.material[pairs.a[p]];
      const bool touches = of.squared[p] * of.inverse_square[p] < 1;
      const bool is_plain = material == pairs.material[pairs.b[p]] && !pairs.near_along[p] &&
                            of.materials[material].law == ContactLaw::barrier;
      plain[counts.plain] = other[counts.other] = p;
      counts.plain += touches & is_plain;
      counts.other += touches & !is_plain;
    }
    return counts;
  }

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
    Plain(const BeadPushing& of, int pair)
        : stiffness(of.materials[of.pairs.material[of.pairs.a[pair]]].contact_stiffness) {}
    Penalty<Real> operator()(const Real& squared, int, int) const { return barrier(stiffness, squared); }
  };
  struct Any {
    const Material &a, &b;
    Screen screen;
    Any(const BeadPushing& of, int pair)
        : a(of.materials[of.pairs.material[of.pairs.a[pair]]]),
          b(of.materials[of.pairs.material[of.pairs.b[pair]]]),
          screen(of.pairs, pair) {}
    [[gnu::always_inline]] Penalty<Real> operator()(const Real& squared, int i, int j) const {
      return penalty(a, b, screen(squared, i, j, 1));
    }
  };

  struct Contact {
    double weight;          // l_a l_b / (n_a n_b), m² (Ding et al. 2023, Eqs. 17-21 as corrected)
    double inverse_square;  // 1/d², 1/m²
    const double* row_b;
    int beads_b;
    double* on_b;
  };

  template <class Law>
  [[gnu::always_inline]] static void push_pair(const BeadPushing& of, int pair, Outgoing& outgoing, Energy& energy) {
    const BeadPairs& pairs = of.pairs;
    const int a = pairs.a[pair], b = pairs.b[pair], stride = stride_of(pairs.rows.stride);
    double* on_b = b < of.reach ? of.push + 3 * stride * long{b - of.first} : leave(pair, 3 * stride, outgoing);
    const Contact contact{of.spacing[a] * of.spacing[b], of.inverse_square[pair], pairs.image + 3 * stride * long{b},
                          end_of(pairs.rows.count[b]), on_b};
    const Law law(of, pair);
    four_at_a_time(
        pairs.rows.count[a], [&]<int count>(int first) __attribute__((always_inline)) {
          const typename Loops::template BeadsOfA<count> beads(pairs.rows.at + 3 * stride * long{a} + first, stride);
          double* on_a = of.push + 3 * stride * long{a - of.first} + first;
          push_beads(law, contact, beads, first, stride, same(pairs.displacement), on_a, energy);
        });
  }

  /// Where a contact that leaves the range pushes b.
  [[gnu::noinline]] static double* leave(int pair, int row, Outgoing& outgoing) {
    double* on_b = outgoing.row;
    for (int i = 0; i < row; ++i) on_b[i] = 0;
    *outgoing.pair++ = pair;
    outgoing.row += row;
    return on_b;
  }

  /// Beads of a, from `first` on. The law is asked about all beads, and answers nothing at the distance of just
  /// touching.
  template <class Law, class BeadsOfA>
  [[gnu::always_inline]] static void push_beads(const Law& law, const Contact& contact, const BeadsOfA& beads,
                                                int first, int stride, const Vector<Real>& displacement, double* on_a,
                                                Energy& energy) {
    const double scale = -contact.weight * contact.inverse_square;
    ByCoordinate<SumsOfA<Real>> sum_a;
    for (int j = 0; j < contact.beads_b; j += step) {
      const int part = j / step % parts;
      const Vector<Real> at_b = beads_of_b(contact.row_b + j, stride) + displacement;
      ByCoordinate<SumsOfB<Real>> sum_b;
      SumsOfB<Real> value;
#pragma GCC unroll 4
      for (int g = 0; g < beads.groups; ++g) {
        const int side = g % sides;
        const Vector<Real> apart = beads.at[g] - at_b;
        const Real squared = minimum(Real(dot(apart, apart) * contact.inverse_square), Real(1));
        const Penalty<Real> f = law(squared, first + g * at_once, j);
        const Vector<Real> push = Real(scale * f.slope) * apart;
        value.of[side] += f.value;
        sum_a.x.of[g][part] += push.x;
        sum_a.y.of[g][part] += push.y;
        sum_a.z.of[g][part] += push.z;
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
    add(added(sum_a.x), on_a);
    add(added(sum_a.y), on_a + stride);
    add(added(sum_a.z), on_a + 2 * stride);
  }

  static void add(const Row<Real>& row, double* to) { store(load_row<Real>(to) + row, to); }
  static void subtract(const Single& x, double* from) { store(Single(load<Single>(from) - x), from); }

  static double sum(const Energy& energy) {
    Row<Real> row;
    for (int part = 0; part < parts; ++part) row.part[part] = added(energy.part[part]);
    return wale::sum(row);
  }
};

/// The same for any stride.
template <class Real>
BeadPushed push_beads(const BeadPushing& of, int first, int last) {
  return of.pairs.rows.stride == row_step ? BeadPushKernel<Real, row_step>::push(of, first, last)
                                          : BeadPushKernel<Real, any_stride>::push(of, first, last);
}

}  // namespace wale
