/// Carries a law at a point of the yarn to the control points: an Effect from its energy density and slopes.
#pragma once

#include <algorithm>
#include <concepts>
#include <numeric>
#include <vector>

#include "sim/effect.hpp"
#include "sim/parts.hpp"
#include "sim/spline.hpp"

namespace wale {

/// A quadrature point of a yarn; ' is d/ds.
struct Site {
  Vec3 y, dy, ddy, v;
  double t = 0;
  double l = 0;   ///< rest length of the segment now, m
  double l0 = 0;  ///< rest length as laid, m
  const Material* yarn = nullptr;
  int segment = 0;
  int index = 0;  ///< counts the sites of the effect, segment by segment
};

/// What a law answers, per unit of s: energy and dissipation, and their slopes. Zero at the start.
struct Slope {
  double energy = 0, dissipation = 0;
  Vec3 y = Vec3::Zero(), dy = Vec3::Zero(), ddy = Vec3::Zero(), v = Vec3::Zero();
};

/// Second slopes. Zero at the start; dy_ddy has dy by rows, ddy by columns.
struct Curvature {
  Mat3 y_y = Mat3::Zero(), dy_dy = Mat3::Zero(), dy_ddy = Mat3::Zero(), ddy_ddy = Mat3::Zero(), v_v = Mat3::Zero();
};

/// `curvature` may be null; `convex` asks for a positive semidefinite one.
template <class L>
concept Law = requires(const L& law, const Site& at, Slope& slope, Curvature* curvature, bool convex) {
  { L::elastic } -> std::convertible_to<bool>;    // true: depends on position; false: on velocity
  { L::derivative } -> std::convertible_to<int>;  // 0: it depends on y or v alone, 1: on y' alone, 2: on y' and y''
  { law.name() } -> std::convertible_to<std::string_view>;
  { law(at, slope, curvature, convex) } -> std::same_as<void>;
};

template <Law L>
class AlongYarn final : public Effect {
 public:
  /// The law at `nodes` Gauss nodes of each of `segments`; the first and the last segment of a yarn take `end_nodes`
  /// if that is more, but in a periodic fabric, whose yarns have no ends. `parts` must outlive the effect's last use.
  AlongYarn(L law, const Parts& parts, int nodes, std::vector<int> segments, int end_nodes = 0)
      : law_(std::move(law)),
        parts_(parts),
        inner_(nodes),
        end_(std::max(nodes, end_nodes)),
        segments_(std::move(segments)) {
    for (const int segment : segments_) {
      first_site_.push_back(sites_);
      sites_ += static_cast<int>(rule_of(segment).nodes.size());
    }
  }

  std::string_view name() const override { return law_.name(); }
  bool dissipative() const override { return !L::elastic; }

  void add(const State& at, Load& out) const override {
    const std::array<Stiffness*, 2> second{L::elastic ? out.stiffness : out.damping, L::elastic ? out.convex : nullptr};
    std::array<const std::vector<int>*, 2> places{};
    for (std::size_t m = 0; m < 2; ++m)
      if (second[m]) places[m] = &places_in(*second[m]);
    std::vector<Scalars> scalars(segments_.size());
    // Where two threads meet, both ask the law about the segments that reach across.
    share_points(static_cast<int>(at.q.cols()), segments_.size() < few, [&](int from, int to) {
      for (int i = 0; i < static_cast<int>(segments_.size()); ++i) {
        const int first = first_point(i);
        if (first + 4 <= from || first >= to) continue;
        const Range mine{std::max(from - first, 0), std::min(to - first, 4)};
        const Scalars of = add_slopes(at, i, mine, out.force);
        if (mine.from == 0) scalars[static_cast<std::size_t>(i)] = of;
        for (std::size_t m = 0; m < 2; ++m)
          if (second[m]) add_second(at, i, mine, m == 1, *places[m], *second[m]);
      }
    });
    for (const Scalars& of : scalars) {
      if (out.energy) *out.energy += of.energy;
      if (out.dissipation) *out.dissipation += of.dissipation;
    }
  }

 private:
  static constexpr std::size_t few = 256;  // segments for which threads cost more than they save
  struct Scalars {
    double energy = 0, dissipation = 0;
  };
  /// Of the four control points of a segment: those that a thread adds to.
  struct Range {
    int from = 0, to = 0;
  };

  struct Rule {
    std::span<const GaussNode> nodes;
    std::vector<Basis> bases;
    explicit Rule(int count) : nodes(gauss(count)) {
      for (const GaussNode& node : nodes) bases.push_back(basis(node.s));
    }
  };

  int first_point(int i) const { return parts_.fabric.first_point(segments_[static_cast<std::size_t>(i)]); }

  const std::vector<int>& places_in(Stiffness& matrix) const {
    return matrix.places(this, 0, [&](std::vector<int>& slots) {
      for (int i = 0; i < static_cast<int>(segments_.size()); ++i)
        for (int j = 0; j < 4; ++j) matrix.slots(first_point(i) + j, first_point(i) + j, 4 - j, slots);
    });
  }

  const Rule& rule_of(int segment) const {
    if (parts_.fabric.cell) return inner_;
    const Yarn& yarn = parts_.fabric.yarns[static_cast<std::size_t>(parts_.fabric.segment(segment).yarn)];
    const int place = segment - yarn.first_segment;
    return place == 0 || place == yarn.segments - 1 ? end_ : inner_;
  }

  Site site(const State& at, int i, std::size_t node, const Basis& b) const {
    const int segment = segments_[static_cast<std::size_t>(i)];
    const int first = first_point(i);
    return {combine(at.q, first, b.value),
            combine(at.q, first, b.first),
            combine(at.q, first, b.second),
            combine(at.v, first, b.value),
            at.t,
            parts_.rest_length(segment, at.t),
            parts_.fabric.segment(segment).length,
            &parts_.fabric.material_of(segment),
            segment,
            first_site_[static_cast<std::size_t>(i)] + static_cast<int>(node)};
  }

  Scalars add_slopes(const State& at, int i, Range mine, Points* force) const {
    const Rule& rule = rule_of(segments_[static_cast<std::size_t>(i)]);
    Scalars sum;
    for (std::size_t node = 0; node < rule.nodes.size(); ++node) {
      const double w = rule.nodes[node].weight;
      const Basis& b = rule.bases[node];
      Slope slope;
      law_(site(at, i, node, b), slope, nullptr, false);
      sum.energy += w * slope.energy;
      sum.dissipation += w * slope.dissipation;
      if (!force) continue;
      for (int point = mine.from; point < mine.to; ++point) {
        const auto k = static_cast<std::size_t>(point);
        force->col(first_point(i) + point) -=
            w * (b.value[k] * (slope.y + slope.v) + b.first[k] * slope.dy + b.second[k] * slope.ddy);
      }
    }
    return sum;
  }

  void add_second(const State& at, int i, Range mine, bool convex, const std::vector<int>& places,
                  Stiffness& out) const {
    // Blocks (j, k) with j <= k of the segment, row by row: so many lie before each row.
    constexpr std::array<std::size_t, 4> before{0, 4, 7, 9};
    const Rule& rule = rule_of(segments_[static_cast<std::size_t>(i)]);
    for (std::size_t node = 0; node < rule.nodes.size(); ++node) {
      const double w = rule.nodes[node].weight;
      const Basis& b = rule.bases[node];
      Slope slope;
      Curvature c;
      law_(site(at, i, node, b), slope, &c, convex);
      for (auto j = static_cast<std::size_t>(mine.from); j < static_cast<std::size_t>(mine.to); ++j) {
        std::size_t place = static_cast<std::size_t>(i) * 10 + before[j];
        const Mat3 by_y = w * b.value[j] * (L::elastic ? c.y_y : c.v_v);
        const Mat3 by_dy = w * (b.first[j] * c.dy_dy + b.second[j] * c.dy_ddy.transpose());
        const Mat3 by_ddy = w * (b.first[j] * c.dy_ddy + b.second[j] * c.ddy_ddy);
        for (std::size_t k = j; k < 4; ++k, ++place) {
          if constexpr (L::derivative == 0) out.add_at(places[place], b.value[k] * by_y);
          if constexpr (L::derivative == 1) out.add_at(places[place], b.first[k] * by_dy);
          if constexpr (L::derivative == 2) out.add_at(places[place], b.first[k] * by_dy + b.second[k] * by_ddy);
        }
      }
    }
  }

  L law_;
  const Parts& parts_;
  Rule inner_, end_;
  std::vector<int> segments_, first_site_;
  int sites_ = 0;
};

inline std::vector<int> all_segments(const Fabric& fabric) {
  std::vector<int> all(fabric.segments.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace wale
