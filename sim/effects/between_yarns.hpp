/// Carries a law between two beads to the control points: an Effect from its energy, push and slopes.
#pragma once

#include <concepts>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "sim/effects/bead_pushes.hpp"
#include "sim/effects/beads.hpp"

namespace wale {

/// Two beads of a listed pair of segments.
struct Touch {
  Vec3 apart = Vec3::Zero();     ///< from bead b to bead a, m
  Vec3 velocity = Vec3::Zero();  ///< of a relative to b, m/s
  double weight = 0;             ///< l_a l_b / (n_a n_b), m² (Ding et al. 2023, Eqs. 17-21 as corrected)
  double diameter = 0;           ///< of this contact, m
  double secant = 0;             ///< see Load
  const Material* a = nullptr;
  const Material* b = nullptr;
};

/// What a law answers; zero at the start.
struct Push {
  double energy = 0, dissipation = 0;
  Vec3 on_a = Vec3::Zero();       ///< force on bead a, N; b gets the opposite
  Mat3 stiffness = Mat3::Zero();  ///< second slope by `apart`, or by `velocity` if the law is not elastic; symmetric
  Mat3 convex = Mat3::Zero();     ///< what of it is positive semidefinite, if the law is elastic
};

/// A law is asked only about beads nearer than their contact diameter.
template <class L>
concept PairLaw = requires(const L& law, const Touch& touch, Push& push, bool second) {
  { L::elastic } -> std::convertible_to<bool>;
  { L::by_kernels } -> std::convertible_to<bool>;
  { law.name() } -> std::convertible_to<std::string_view>;
  {
    law.diameter(touch.diameter, 0.0, 0.0)
    } -> std::convertible_to<double>;  // of two beads so far apart on their yarns
  { law(touch, push, second) } -> std::same_as<void>;
};

/// A law whose `by_kernels` is true is that of the materials, see contact_law.hpp: the force kernels know it, and it is
/// asked where second slopes are wanted only.
template <PairLaw L>
class BetweenYarns final : public Effect {
 public:
  BetweenYarns(L law, const Parts& parts, std::shared_ptr<Beads> beads)
      : law_(std::move(law)), parts_(parts), beads_(std::move(beads)) {}

  std::string_view name() const override { return law_.name(); }
  bool dissipative() const override { return !L::elastic; }
  void prepare(const State& at) override {
    beads_->prepare(at.q);
    if constexpr (L::by_kernels) look_at(parts_.rest(at.t));
  }
  double closest() const override { return L::elastic ? beads_->closest() : Effect::closest(); }
  void list_gaps(std::vector<Gap>& out) const override {
    if constexpr (L::elastic) beads_->list_gaps(out);
  }

  void add(const State& at, Load& out) const override {
    Stiffness* const second = L::elastic ? out.stiffness : out.damping;
    if constexpr (L::by_kernels) {
      if (out.energy || out.force) add_pushes(*beads_, at.q, spacing_, inverse_square_, out);
      if (!second && !out.convex) return;
    }
    std::vector<Contact> contacts;
    list(spacings(parts_.rest(at.t)), contacts);
    if (!L::by_kernels || second) add(at, contacts, &Push::stiffness, second, out);
    if (!L::elastic || !out.convex) return;
    Load no_slopes{.secant = out.secant};
    add(at, contacts, &Push::convex, out.convex, no_slopes);
  }

 private:
  static constexpr std::size_t period_blocks = 8 * 2 + 3;
  static constexpr std::size_t own_blocks = 10, mixed_blocks = 16;  // of a segment, of two
  static constexpr std::size_t few = 64;                            // pairs for which threads cost more than they save
  static constexpr std::size_t most_blocks = 512;                   // pairs whose blocks fit a core's cache
  using Quad = Eigen::Matrix<double, 3, 4>;
  /// A symmetric 3 x 3 matrix by its upper triangle, row by row.
  using Triangle = Eigen::Array<double, 6, 1>;
  /// Blocks (j, k), j <= k, of the eight control points of a pair, row by row.
  using Blocks = std::array<Triangle, 36>;
  /// Two segments that touch.
  struct Contact {
    std::size_t pair = 0;  // of Beads::pairs()
    double weight = 0;     // see Touch
    double diameter = 0;
  };
  struct Slopes {
    double energy = 0, dissipation = 0;
    Quad on_a = Quad::Zero(), on_b = Quad::Zero();
  };

  /// Adds the slopes that `out` wants, unless kernels know them, and to `matrix`, if there is one, the second slope.
  void add(const State& at, const std::vector<Contact>& contacts, Mat3 Push::*second, Stiffness* matrix,
           Load& out) const {
    const std::vector<int>* const places = matrix ? &places_in(*matrix) : nullptr;
    const std::size_t batch = matrix ? std::min(contacts.size(), most_blocks) : contacts.size();
    std::vector<Slopes> slopes(batch);
    std::vector<Blocks> blocks(matrix ? batch : 0);
    for (std::size_t first = 0; first < contacts.size(); first += batch) {
      const std::span<const Contact> some(contacts.data() + first, std::min(batch, contacts.size() - first));
#pragma omp parallel if (some.size() > few)
      {
        std::vector<Triangle> on_b;
#pragma omp for schedule(dynamic, 16)
        for (std::size_t c = 0; c < some.size(); ++c) {
          slopes[c] = {};
          push_all(at, some[c], out.secant, second, slopes[c], matrix ? &blocks[c] : nullptr, on_b);
        }
      }
      if constexpr (!L::by_kernels) gather(some, slopes, at.q, out);
      if (!matrix) continue;
      gather(some, blocks, *places, *matrix);
      if (beads_->images().size() == 1) continue;
      if (beads_->turned(1))
        gather_turned(some, blocks, slopes, at.q, second == &Push::stiffness, *matrix);
      else
        gather_periods(some, blocks, *matrix);
    }
  }

  const SegmentPair& pair_of(const Contact& contact) const { return beads_->pairs()[contact.pair]; }

  static Vec3 velocity_of(const Eigen::Vector2d& image, const State& at) { return at.v.rightCols<2>() * image; }
  /// Those of the images of four control points.
  static Points velocities_of(const Image& image, int first, const State& at) {
    Points of = image.turn() * at.v.middleCols<4>(first);
    for (int k = 0; k < 4; ++k)
      for (int period = 0; period < 2; ++period)
        of.col(k) += image.by_period(at.q.col(first + k), period) * at.v.rightCols<2>().col(period);
    return of;
  }

  /// How far apart beads are on their yarn, by segment, m.
  std::vector<double> spacings(const RestLengths& rest) const {
    std::vector<double> spacing;
    spacing.reserve(parts_.fabric.segments.size());
    for (int i = 0; i < parts_.fabric.segment_count(); ++i)
      spacing.push_back(rest.of(parts_.fabric.segment(i)) / beads_->count(i));
    return spacing;
  }

  double diameter(const SegmentPair& pair, const std::vector<double>& spacing) const {
    return law_.diameter(beads_->diameter(pair.a, pair.b), spacing[static_cast<std::size_t>(pair.a)],
                         spacing[static_cast<std::size_t>(pair.b)]);
  }

  /// Works out what the kernels are told of the pairs, if it has changed.
  void look_at(const RestLengths& rest) {
    if (list_ == beads_->version() && rest == rest_) return;
    list_ = beads_->version();
    rest_ = rest;
    spacing_ = spacings(rest);
    inverse_square_.clear();
    for (const SegmentPair& pair : beads_->pairs()) {
      const double d = diameter(pair, spacing_);
      inverse_square_.push_back(1 / (d * d));
    }
  }

  /// The listed pairs that touch.
  void list(const std::vector<double>& spacing, std::vector<Contact>& out) const {
    // Most of them do, but a branch would often be taken wrongly.
    const std::vector<SegmentPair>& pairs = beads_->pairs();
    std::vector<std::size_t> touching(pairs.size() + 1);
    std::size_t count = 0;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      const double d = diameter(pairs[p], spacing);
      touching[count] = p;
      count += beads_->squared_distance(p) < d * d;
    }
    out.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const SegmentPair& pair = pairs[touching[i]];
      out.push_back({.pair = touching[i],
                     .weight = spacing[static_cast<std::size_t>(pair.a)] * spacing[static_cast<std::size_t>(pair.b)],
                     .diameter = diameter(pair, spacing)});
    }
  }

  /// `on_b` is working space.
  void push_all(const State& at, const Contact& contact, double secant, Mat3 Push::*second, Slopes& slopes,
                Blocks* blocks, std::vector<Triangle>& on_b) const {
    const auto [a, b, image] = pair_of(contact);
    const Vec3 displacement = beads_->displacement(pair_of(contact));
    const int first_a = parts_.fabric.first_point(a), first_b = parts_.fabric.first_point(b);
    const Image* const turned = beads_->turned(image);
    const Vec3 moving_on = image > 0 && !turned ? velocity_of(image_of(contact), at) : Vec3(Vec3::Zero());
    const Points of_images = turned ? velocities_of(*turned, first_b, at) : Points();
    const auto velocity_of_b = [&](const Basis& bb) {
      return turned ? combine(of_images, 0, bb.value) : combine(at.v, first_b, bb.value);
    };
    Touch touch{.weight = contact.weight,
                .diameter = contact.diameter,
                .secant = secant,
                .a = &parts_.fabric.material_of(a),
                .b = &parts_.fabric.material_of(b)};
    if (blocks) blocks->fill(Triangle::Zero());
    on_b.assign(static_cast<std::size_t>(beads_->count(b)), Triangle::Zero());
    for (int i = 0; i < beads_->count(a); ++i) {
      const Basis& ba = beads_->basis_of(a, i);
      Triangle on_a = Triangle::Zero();
      std::array<Triangle, 4> mixed;
      mixed.fill(Triangle::Zero());
      bool touched = false;
      for (int j = 0; j < beads_->count(b); ++j) {
        touch.apart = beads_->position(a, i) - beads_->position_of_image(pair_of(contact), j) - displacement;
        if (touch.apart.squaredNorm() >= touch.diameter * touch.diameter) continue;
        if (beads_->screened(pair_of(contact), i, j)) continue;
        const Basis& bb = beads_->basis_of(b, j);
        touch.velocity = combine(at.v, first_a, ba.value) - velocity_of_b(bb) - moving_on;
        Push push;
        law_(touch, push, blocks != nullptr);
        add_slopes(push, ba, bb, slopes);
        if (!blocks) continue;
        touched = true;
        const Triangle slope = triangle(push.*second);
        on_a += slope;
        on_b[static_cast<std::size_t>(j)] += slope;
        for (std::size_t k = 0; k < 4; ++k) mixed[k] -= bb.value[k] * slope;
      }
      if (touched) add_rows_of_a(ba, on_a, mixed, *blocks);
    }
    if (blocks) add_rows_of_b(b, on_b, *blocks);
  }

  static Triangle triangle(const Mat3& of) {
    Triangle upper;
    upper << of(0, 0), of(0, 1), of(0, 2), of(1, 1), of(1, 2), of(2, 2);
    return upper;
  }

  static void add_slopes(const Push& push, const Basis& ba, const Basis& bb, Slopes& slopes) {
    slopes.energy += push.energy;
    slopes.dissipation += push.dissipation;
    for (std::size_t k = 0; k < 4; ++k) {
      slopes.on_a.col(static_cast<Eigen::Index>(k)) += ba.value[k] * push.on_a;
      slopes.on_b.col(static_cast<Eigen::Index>(k)) -= bb.value[k] * push.on_a;
    }
  }

  /// What bead i of a and all that it touches add to the blocks of a's control points.
  static void add_rows_of_a(const Basis& ba, const Triangle& on_a, const std::array<Triangle, 4>& mixed,
                            Blocks& blocks) {
    std::size_t block = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = j; k < 4; ++k, ++block) blocks[block] += ba.value[j] * ba.value[k] * on_a;
      for (std::size_t k = 0; k < 4; ++k, ++block) blocks[block] += ba.value[j] * mixed[k];
    }
  }

  void add_rows_of_b(int b, const std::vector<Triangle>& on_b, Blocks& blocks) const {
    for (std::size_t i = 0; i < on_b.size(); ++i) {
      const Basis& bb = beads_->basis_of(b, static_cast<int>(i));
      std::size_t block = 26;  // after those of a
      for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t k = j; k < 4; ++k, ++block) blocks[block] += bb.value[j] * bb.value[k] * on_b[i];
    }
  }

  void gather(std::span<const Contact> contacts, const std::vector<Slopes>& slopes, const Points& q, Load& out) const {
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      if (out.energy) *out.energy += slopes[c].energy;
      if (out.dissipation) *out.dissipation += slopes[c].dissipation;
      if (!out.force) continue;
      out.force->middleCols<4>(parts_.fabric.first_point(pair_of(contacts[c]).a)) += slopes[c].on_a;
      const int first_b = parts_.fabric.first_point(pair_of(contacts[c]).b);
      if (const Image* turned = beads_->turned(pair_of(contacts[c]))) {
        const OnImage back = carried_back(*turned, q.middleCols<4>(first_b), slopes[c].on_b);
        out.force->middleCols<4>(first_b) += back.points;
        out.force->rightCols<2>() += back.periods;
        continue;
      }
      out.force->middleCols<4>(first_b) += slopes[c].on_b;
      // An image moves with the periods: together they bear what its control points do.
      if (pair_of(contacts[c]).image > 0)
        out.force->rightCols<2>() += slopes[c].on_b.rowwise().sum() * image_of(contacts[c]).transpose();
    }
  }

  void gather(std::span<const Contact> contacts, const std::vector<Blocks>& blocks, const std::vector<int>& places,
              Stiffness& out) const {
    share_points(out.points(), contacts.size() < few, [&](int first, int last) {
      for (std::size_t c = 0; c < contacts.size(); ++c) {
        const SegmentPair& pair = pair_of(contacts[c]);
        if (beads_->turned(pair)) continue;
        std::size_t block = 0;
        for (int j = 0; j < 8; ++j)
          for (int k = j; k < 8; ++k, ++block) {
            const std::size_t place = place_of(contacts[c].pair, j, k);
            const int p = point(pair, j), q = point(pair, k), row = std::min(p, q);
            if (row < first || row >= last) continue;
            // The two segments may share a control point.
            const double times = p == q && j != k ? 2 : 1;
            out.add_at(places[place], times * whole(blocks[c][block]));
          }
      }
    });
  }

  /// What images add to the blocks of the two periods: where an image is displaced by a period, that moves as the four
  /// control points of b do together.
  void gather_periods(std::span<const Contact> contacts, const std::vector<Blocks>& blocks, Stiffness& out) const {
    const std::vector<int>& places = period_places_in(out);
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      if (pair_of(contacts[c]).image == 0) continue;
      const Eigen::Vector2d image = image_of(contacts[c]);
      auto place =
          places.begin() + static_cast<std::ptrdiff_t>((contacts[c].pair - beads_->plain_pairs()) * period_blocks);
      Triangle both = Triangle::Zero();
      for (std::size_t j = 0; j < 8; ++j) {
        Triangle by_b = Triangle::Zero();
        for (std::size_t k = 4; k < 8; ++k) by_b += blocks[c][block_at(std::min(j, k), std::max(j, k))];
        if (j >= 4) both += by_b;
        for (int period = 0; period < 2; ++period) out.add_at(*place++, image[period] * whole(by_b));
      }
      const Mat3 by_periods = whole(both);
      out.add_at(*place++, image[0] * image[0] * by_periods);
      out.add_at(*place++, image[0] * image[1] * by_periods);
      out.add_at(*place++, image[1] * image[1] * by_periods);
    }
  }

  /// The same of images that turn, and of their control points as well. What moves them are four control points and the
  /// periods; and as they turn as these move, forces on them change direction.
  void gather_turned(std::span<const Contact> contacts, const std::vector<Blocks>& blocks,
                     const std::vector<Slopes>& slopes, const Points& q, bool is_exact, Stiffness& out) const {
    const std::vector<int>* places = nullptr;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const SegmentPair& pair = pair_of(contacts[c]);
      const Image* const image = beads_->turned(pair);
      if (!image) continue;
      if (!places) places = &turned_places_in(out);
      const Quad points = q.middleCols<4>(parts_.fabric.first_point(pair.b));
      const MovedBy moved = moved_by(*image, points);
      ByMovers by_movers = moved.transpose() * whole(blocks[c]) * moved;
      if (L::elastic && is_exact) subtract_turning(*image, points, slopes[c].on_b, by_movers);
      add_by_movers(pair, by_movers, places->begin() + place_of_turned(contacts[c].pair), out);
    }
  }

  static constexpr int movers = 10;  // eight control points and two periods
  static constexpr std::ptrdiff_t turned_blocks = movers * (movers + 1) / 2;
  using ByMovers = Eigen::Matrix<double, 3 * movers, 3 * movers>;
  using ByEight = Eigen::Matrix<double, 24, 24>;
  using MovedBy = Eigen::Matrix<double, 24, 3 * movers>;

  std::ptrdiff_t place_of_turned(std::size_t pair) const {
    return static_cast<std::ptrdiff_t>(pair - beads_->plain_pairs()) * turned_blocks;
  }

  static ByEight whole(const Blocks& blocks) {
    ByEight all;
    for (std::size_t j = 0; j < 8; ++j)
      for (std::size_t k = 0; k < 8; ++k)
        all.block<3, 3>(static_cast<int>(3 * j), static_cast<int>(3 * k)) =
            whole(blocks[block_at(std::min(j, k), std::max(j, k))]);
    return all;
  }

  /// The control points of a and the images of b's by what moves them.
  static MovedBy moved_by(const Image& image, const Quad& points) {
    MovedBy by = MovedBy::Zero();
    by.topLeftCorner<12, 12>().setIdentity();
    for (int k = 0; k < 4; ++k) {
      by.block<3, 3>(12 + 3 * k, 12 + 3 * k) = image.turn();
      for (int period = 0; period < 2; ++period)
        by.block<3, 3>(12 + 3 * k, 24 + 3 * period) = image.by_period(points.col(k), period);
    }
    return by;
  }

  static void subtract_turning(const Image& image, const Quad& points, const Quad& forces, ByMovers& by) {
    for (int k = 0; k < 4; ++k)
      for (int first = 0; first < 2; ++first) {
        const Mat3 mixed = image.mixed(forces.col(k), first);
        by.block<3, 3>(12 + 3 * k, 24 + 3 * first) -= mixed;
        by.block<3, 3>(24 + 3 * first, 12 + 3 * k) -= mixed.transpose();
        for (int second = 0; second < 2; ++second)
          by.block<3, 3>(24 + 3 * first, 24 + 3 * second) -=
              image.by_periods(forces.col(k), points.col(k), first, second);
      }
  }

  /// The column of State::q that moves a pair.
  int mover(const SegmentPair& pair, int k) const {
    return k < 8 ? point(pair, k) : static_cast<int>(parts_.fabric.points.cols()) + k - 8;
  }

  void add_by_movers(const SegmentPair& pair, const ByMovers& by, std::vector<int>::const_iterator place,
                     Stiffness& out) const {
    for (int j = 0; j < movers; ++j)
      for (int k = j; k < movers; ++k) {
        const Mat3 block = by.block<3, 3>(3 * j, 3 * k);
        const int p = mover(pair, j), q = mover(pair, k);
        // The two segments may share a control point.
        const bool twice = p == q && j != k;
        out.add_at(*place++, twice ? Mat3(block + block.transpose()) : p <= q ? block : Mat3(block.transpose()));
      }
  }

  /// Where block (j, k), j <= k, of the eight control points of a pair is.
  static constexpr std::size_t block_at(std::size_t j, std::size_t k) { return j * 8 - j * (j + 1) / 2 + k; }

  static Mat3 whole(const Triangle& s) {
    Mat3 all;
    all << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
    return all;
  }

  Eigen::Vector2d image_of(const Contact& contact) const {
    return beads_->images()[static_cast<std::size_t>(pair_of(contact).image)].template cast<double>();
  }

  int point(const SegmentPair& pair, int k) const { return parts_.fabric.first_point(k < 4 ? pair.a : pair.b) + k % 4; }

  /// Where places_in() has block (j, k), j <= k, of the eight control points of a pair.
  std::size_t place_of(std::size_t pair, int j, int k) const {
    if (j < 4 && k >= 4)
      return own_blocks * parts_.fabric.segments.size() + mixed_blocks * pair + static_cast<std::size_t>(4 * j + k - 4);
    const SegmentPair& of = beads_->pairs()[pair];
    const int first = j % 4;
    return own_blocks * static_cast<std::size_t>(k < 4 ? of.a : of.b) +
           static_cast<std::size_t>(4 * first - first * (first + 1) / 2 + k % 4);
  }

  /// Calls act(i, j, blocks, at) for every run of blocks (i, j) ... (i, j + blocks - 1) of a segment's own, or of those
  /// that a pair mixes, which come `at` so many. While it answers true.
  template <class Act>
  bool each_own(int segment, const Act& act) const {
    const int first = parts_.fabric.first_point(segment);
    for (int j = 0, at = 0; j < 4; at += 4 - j, ++j)
      if (!act(first + j, first + j, 4 - j, at)) return false;
    return true;
  }
  template <class Act>
  bool each_mixed(const SegmentPair& pair, const Act& act) const {
    const int a = point(pair, 0), b = point(pair, 4), at_once = b >= a + 4 ? 4 : 1;
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; k += at_once)
        if (!act(std::min(a + j, b + k), std::max(a + j, b + k), at_once, 4 * j + k)) return false;
    return true;
  }

  /// Appends the slots of `count` times `blocks` blocks, each(n, act): on all threads where there are all of them.
  template <class Each>
  static void list(Stiffness& matrix, std::size_t count, std::size_t blocks, const Each& each,
                   std::vector<int>& slots) {
    const std::size_t before = slots.size();
    slots.resize(before + count * blocks);
#pragma omp parallel for schedule(static)
    for (std::size_t n = 0; n < count; ++n) {
      int* const of = slots.data() + before + n * blocks;
      if (!each(n, [&](int i, int j, int run, int at) { return matrix.find_slots(i, j, run, of + at); })) of[0] = -1;
    }
    for (std::size_t n = 0; n < count; ++n) {
      int* const of = slots.data() + before + n * blocks;
      if (of[0] < 0)
        each(n, [&](int i, int j, int run, int at) { return matrix.make_slots(i, j, run, of + at), true; });
    }
  }

  /// The slots of every segment's own blocks, then of those that every listed pair mixes, touching or not, so that the
  /// pattern changes only with the list.
  const std::vector<int>& places_in(Stiffness& matrix) const {
    return matrix.places(this, beads_->version(), [&](std::vector<int>& slots) {
      const auto segments = static_cast<std::size_t>(parts_.fabric.segment_count());
      const auto own = [&](std::size_t i, const auto& act) { return each_own(static_cast<int>(i), act); };
      const auto mixed = [&](std::size_t p, const auto& act) { return each_mixed(beads_->pairs()[p], act); };
      list(matrix, segments, own_blocks, own, slots);
      list(matrix, beads_->pairs().size(), mixed_blocks, mixed, slots);
    });
  }

  /// Of each pair with an image: the blocks of its eight control points with either period, then those of the periods.
  const std::vector<int>& period_places_in(Stiffness& matrix) const {
    return matrix.places(beads_.get(), beads_->version(), [&](std::vector<int>& slots) {
      const int course = static_cast<int>(parts_.fabric.points.cols()), wale = course + 1;
      for (std::size_t p = beads_->plain_pairs(); p < beads_->pairs().size(); ++p) {
        for (int j = 0; j < 8; ++j) matrix.slots(point(beads_->pairs()[p], j), course, 2, slots);
        matrix.slots(course, course, 2, slots);
        matrix.slots(wale, wale, 1, slots);
      }
    });
  }

  /// Of each pair with an image that turns: the blocks of what moves it.
  const std::vector<int>& turned_places_in(Stiffness& matrix) const {
    return matrix.places(&law_, beads_->version(), [&](std::vector<int>& slots) {
      for (std::size_t p = beads_->plain_pairs(); p < beads_->pairs().size(); ++p)
        for (int j = 0; j < movers; ++j)
          for (int k = j; k < movers; ++k) {
            const int i = mover(beads_->pairs()[p], j), other = mover(beads_->pairs()[p], k);
            slots.push_back(matrix.slot(std::min(i, other), std::max(i, other)));
          }
    });
  }

  L law_;
  const Parts& parts_;
  std::shared_ptr<Beads> beads_;
  // For the kernels, of the list and the rest lengths at the last prepare(); see add_pushes().
  long list_ = -1;
  RestLengths rest_;
  std::vector<double> spacing_, inverse_square_;
};

}  // namespace wale
