/// Carries a law between two beads to the control points: an Effect from its energy, push and slopes.
#pragma once

#include <concepts>
#include <memory>
#include <utility>
#include <vector>

#include "sim/effects/beads.hpp"

namespace wale {

/// Two beads of a listed pair of segments.
struct Touch {
  Vec3 apart;           ///< from bead b to bead a, m
  Vec3 velocity;        ///< of a relative to b, m/s
  double weight = 0;    ///< l_a l_b / (n_a n_b), m² (Ding et al. 2023, Eqs. 17-21 as corrected)
  double diameter = 0;  ///< of this contact, m
  const Material* a = nullptr;
  const Material* b = nullptr;
};

/// What a law answers; zero at the start.
struct Push {
  double energy = 0, dissipation = 0;
  Vec3 on_a = Vec3::Zero();       ///< force on bead a, N; b gets the opposite
  Mat3 stiffness = Mat3::Zero();  ///< second slope by `apart`, or by `velocity` if the law is not elastic
};

/// A law is asked only about beads nearer than their contact diameter.
template <class L>
concept PairLaw = requires(const L& law, const Touch& touch, Push& push, bool second, bool convex) {
  { L::elastic } -> std::convertible_to<bool>;
  { law.name() } -> std::convertible_to<std::string_view>;
  {
    law.diameter(touch.diameter, 0.0, 0.0)
    } -> std::convertible_to<double>;  // of two beads so far apart on their yarns
  { law(touch, push, second, convex) } -> std::same_as<void>;
};

template <PairLaw L>
class BetweenYarns final : public Effect {
 public:
  BetweenYarns(L law, const Parts& parts, std::shared_ptr<Beads> beads)
      : law_(std::move(law)), parts_(parts), beads_(std::move(beads)) {}

  std::string_view name() const override { return law_.name(); }
  void prepare(const State& at) override { beads_->prepare(at.q); }
  double closest() const override { return beads_->closest(); }

  void add(const State& at, Load& out) const override {
    const auto& pairs = beads_->pairs();
    const bool second = L::elastic ? out.stiffness : out.damping;
    std::vector<Local> locals(pairs.size());
#pragma omp parallel for schedule(dynamic, 128) if (pairs.size() > few)
    for (std::size_t p = 0; p < pairs.size(); ++p) touch_all(at, pairs[p], second, out.convex, locals[p]);
    if (second) make_room(L::elastic ? *out.stiffness : *out.damping);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      if (!locals[p].touching) continue;
      if (second) scatter(pairs[p], *locals[p].second, L::elastic ? *out.stiffness : *out.damping);
      if (out.energy) *out.energy += locals[p].energy;
      if (out.dissipation) *out.dissipation += locals[p].dissipation;
      if (!out.force) continue;
      out.force->middleCols<4>(parts_.fabric.first_point(pairs[p].a)) += locals[p].on_a;
      out.force->middleCols<4>(parts_.fabric.first_point(pairs[p].b)) += locals[p].on_b;
    }
  }

 private:
  static constexpr std::size_t few = 256;  // pairs for which threads cost more than they save
  using Quad = Eigen::Matrix<double, 3, 4>;
  /// Blocks (j, k), j <= k, of the eight control points of a pair, row by row.
  using Blocks = std::array<Mat3, 36>;
  struct Local {
    bool touching = false;
    double energy = 0, dissipation = 0;
    Quad on_a = Quad::Zero(), on_b = Quad::Zero();
    std::unique_ptr<Blocks> second;  // only of pairs that touch: most listed ones do not
  };

  void touch_all(const State& at, const SegmentPair& pair, bool second, bool convex, Local& local) const {
    const Fabric& fabric = parts_.fabric;
    const int na = beads_->count(pair.a), nb = beads_->count(pair.b);
    const double la = parts_.rest_length(pair.a, at.t) / na, lb = parts_.rest_length(pair.b, at.t) / nb;
    Touch touch{{},
                {},
                la * lb,
                law_.diameter(beads_->diameter(pair.a, pair.b), la, lb),
                &fabric.material_of(pair.a),
                &fabric.material_of(pair.b)};
    const int first_a = fabric.first_point(pair.a), first_b = fabric.first_point(pair.b);
    for (int i = 0; i < na; ++i) {
      const Basis& ba = beads_->basis_of(pair.a, i);
      const Vec3 ya = combine(at.q, first_a, ba.value);
      for (int j = 0; j < nb; ++j) {
        const Basis& bb = beads_->basis_of(pair.b, j);
        touch.apart = ya - combine(at.q, first_b, bb.value);
        if (touch.apart.squaredNorm() >= touch.diameter * touch.diameter) continue;
        if (beads_->screened(pair.a, i, pair.b, j)) continue;
        touch.velocity = combine(at.v, first_a, ba.value) - combine(at.v, first_b, bb.value);
        local.touching = true;
        if (second && !local.second) {
          local.second = std::make_unique<Blocks>();
          local.second->fill(Mat3::Zero());
        }
        add_touch(touch, ba, bb, convex, local);
      }
    }
  }

  void add_touch(const Touch& touch, const Basis& ba, const Basis& bb, bool convex, Local& local) const {
    Push push;
    law_(touch, push, local.second != nullptr, convex);
    local.energy += push.energy;
    local.dissipation += push.dissipation;
    std::array<double, 8> weight;
    for (std::size_t k = 0; k < 4; ++k) {
      weight[k] = ba.value[k];
      weight[k + 4] = -bb.value[k];
      local.on_a.col(static_cast<Eigen::Index>(k)) += ba.value[k] * push.on_a;
      local.on_b.col(static_cast<Eigen::Index>(k)) -= bb.value[k] * push.on_a;
    }
    if (!local.second) return;
    std::size_t block = 0;
    for (std::size_t j = 0; j < 8; ++j)
      for (std::size_t k = j; k < 8; ++k, ++block) (*local.second)[block] += weight[j] * weight[k] * push.stiffness;
  }

  int point(const SegmentPair& pair, int k) const { return parts_.fabric.first_point(k < 4 ? pair.a : pair.b) + k % 4; }

  /// Every listed pair gets its room in the pattern, touching or not, so that the pattern changes only with the list.
  void make_room(Stiffness& out) const {
    if (!out.admit(this, beads_->version())) return;
    for (const SegmentPair& pair : beads_->pairs())
      for (int j = 0; j < 4; ++j)
        for (int k = 4; k < 8; ++k) {
          const int p = point(pair, j), q = point(pair, k);
          out.touch(std::min(p, q), std::max(p, q));
        }
  }

  void scatter(const SegmentPair& pair, const Blocks& blocks, Stiffness& out) const {
    std::size_t block = 0;
    for (int j = 0; j < 8; ++j)
      for (int k = j; k < 8; ++k, ++block) {
        const int p = point(pair, j), q = point(pair, k);
        if (p == q && j != k)
          out.add(p, p, 2 * blocks[block]);  // the two segments share this control point
        else
          out.add(std::min(p, q), std::max(p, q), blocks[block]);
      }
  }

  L law_;
  const Parts& parts_;
  std::shared_ptr<Beads> beads_;
};

}  // namespace wale
