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
  { L::elastic } -> std::convertible_to<bool>;  // true: depends on position; false: on velocity
  { law.name() } -> std::convertible_to<std::string_view>;
  { law(at, slope, curvature, convex) } -> std::same_as<void>;
};

template <Law L>
class AlongYarn final : public Effect {
 public:
  /// The law at `nodes` Gauss nodes of each of `segments`; the first and the last segment of a yarn take `end_nodes`
  /// if that is more. `parts` must outlive the effect's last use.
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

  void add(const State& at, Load& out) const override {
    const int count = static_cast<int>(segments_.size());
    std::vector<Local> locals(static_cast<std::size_t>(count));
    std::vector<LocalSecond> seconds(out.stiffness || out.damping ? static_cast<std::size_t>(count) : 0);
#pragma omp parallel for schedule(static) if (count > few)
    for (int i = 0; i < count; ++i)
      integrate(at, i, out.convex, locals[static_cast<std::size_t>(i)],
                seconds.empty() ? nullptr : &seconds[static_cast<std::size_t>(i)]);
    gather(locals, seconds, out);
  }

 private:
  static constexpr int few = 64;  // segments for which threads cost more than they save
  struct Local {
    double energy = 0, dissipation = 0;
    Eigen::Matrix<double, 3, 4> force = Eigen::Matrix<double, 3, 4>::Zero();
  };
  /// Blocks (a, b) with a <= b of the four control points, row by row.
  struct LocalSecond {
    std::array<Mat3, 10> stiffness, damping;
    LocalSecond() {
      stiffness.fill(Mat3::Zero());
      damping.fill(Mat3::Zero());
    }
  };

  struct Rule {
    std::span<const GaussNode> nodes;
    std::vector<Basis> bases;
    explicit Rule(int count) : nodes(gauss(count)) {
      for (const GaussNode& node : nodes) bases.push_back(basis(node.s));
    }
  };

  const Rule& rule_of(int segment) const {
    const Yarn& yarn = parts_.fabric.yarns[static_cast<std::size_t>(parts_.fabric.segment(segment).yarn)];
    const int place = segment - yarn.first_segment;
    return place == 0 || place == yarn.segments - 1 ? end_ : inner_;
  }

  Site site(const State& at, int i, std::size_t node, const Basis& b) const {
    const int segment = segments_[static_cast<std::size_t>(i)];
    const int first = parts_.fabric.first_point(segment);
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

  void integrate(const State& at, int i, bool convex, Local& local, LocalSecond* second) const {
    const Rule& rule = rule_of(segments_[static_cast<std::size_t>(i)]);
    for (std::size_t node = 0; node < rule.nodes.size(); ++node) {
      const double w = rule.nodes[node].weight;
      const Basis& b = rule.bases[node];
      Slope slope;
      Curvature curvature;
      law_(site(at, i, node, b), slope, second ? &curvature : nullptr, convex);
      local.energy += w * slope.energy;
      local.dissipation += w * slope.dissipation;
      for (std::size_t k = 0; k < 4; ++k)
        local.force.col(static_cast<Eigen::Index>(k)) -=
            w * (b.value[k] * (slope.y + slope.v) + b.first[k] * slope.dy + b.second[k] * slope.ddy);
      if (second) add_second(w, b, curvature, *second);
    }
  }

  static void add_second(double w, const Basis& b, const Curvature& c, LocalSecond& second) {
    std::size_t block = 0;
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = j; k < 4; ++k, ++block) {
        second.stiffness[block] +=
            w *
            (b.value[j] * b.value[k] * c.y_y + b.first[j] * b.first[k] * c.dy_dy + b.first[j] * b.second[k] * c.dy_ddy +
             b.second[j] * b.first[k] * c.dy_ddy.transpose() + b.second[j] * b.second[k] * c.ddy_ddy);
        second.damping[block] += w * b.value[j] * b.value[k] * c.v_v;
      }
  }

  void gather(const std::vector<Local>& locals, const std::vector<LocalSecond>& seconds, Load& out) const {
    for (std::size_t i = 0; i < locals.size(); ++i) {
      const int first = parts_.fabric.first_point(segments_[i]);
      if (out.energy) *out.energy += locals[i].energy;
      if (out.dissipation) *out.dissipation += locals[i].dissipation;
      if (out.force) out.force->middleCols<4>(first) += locals[i].force;
      if (seconds.empty()) continue;
      std::size_t block = 0;
      for (int j = 0; j < 4; ++j)
        for (int k = j; k < 4; ++k, ++block) {
          if (out.stiffness && L::elastic) out.stiffness->add(first + j, first + k, seconds[i].stiffness[block]);
          if (out.damping && !L::elastic) out.damping->add(first + j, first + k, seconds[i].damping[block]);
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
