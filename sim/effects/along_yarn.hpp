/// Carries a law at a point of the yarn to the control points: an Effect from its energy density and slopes.
#pragma once

#include <algorithm>
#include <concepts>
#include <numeric>
#include <vector>

#include "sim/effect.hpp"
#include "sim/effects/segment_blocks.hpp"
#include "sim/kernels/kernels.hpp"
#include "sim/kernels/site.hpp"
#include "sim/parts.hpp"
#include "sim/spline.hpp"

namespace wale {

/// Second slopes. Zero at the start; dy_ddy has dy by rows, ddy by columns.
struct Curvature {
  Mat3 y_y = Mat3::Zero(), dy_dy = Mat3::Zero(), dy_ddy = Mat3::Zero(), ddy_ddy = Mat3::Zero(), v_v = Mat3::Zero();
};

inline Vector<double> to_vector(const Vec3& a) { return {a.x(), a.y(), a.z()}; }
inline Vec3 to_vec3(const Vector<double>& a) { return {a.x, a.y, a.z}; }

/// What an effect along the yarn is: `Slopes` is the law's energy and its slopes, one of those that the force kernels
/// know; see kernels.hpp. `slopes` gives them for one time, `now` for the curvature. `convex` asks for a positive
/// semidefinite one.
template <class L>
concept Law = requires(const L& law, const typename L::Slopes& now, double t, const Material& yarn,
                       const Site<double>& at, Curvature& curvature, bool convex) {
  { L::Slopes::elastic } -> std::convertible_to<bool>;  // true: depends on position; false: on velocity
  {
    L::Slopes::derivative
    } -> std::convertible_to<int>;  // 0: it depends on y or v alone, 1: on y' alone, 2: on y' and
                                    // y''
  { law.name() } -> std::convertible_to<std::string_view>;
  { law.slopes(t) } -> std::convertible_to<typename L::Slopes>;
  { law.constant(yarn) } -> std::convertible_to<double>;  // Site::constant
  { law.curvature(now, at, curvature, convex) } -> std::same_as<void>;
};

/// What a schedule leads may push what rests.
template <class L>
concept Led = requires(const L& law) {
  law.spec.progress;
};

/// What acts in one place only: whether it may on yarn with this constant in a ball about `centre` of this radius, m.
template <class L>
concept Local = requires(const L& law, const typename L::Slopes& now, const Vec3& centre, double radius,
                         double constant) {
  { law.reaches(now, centre, radius, constant) } -> std::same_as<bool>;
};

/// Sets Site::reference of a law that keeps something of each site.
template <class L>
concept Remembers = requires(const L& law, const Parts& parts, int first_point, const NodeWeights& node) {
  { law.reference(parts, first_point, node) } -> std::convertible_to<Vec3>;
};

template <Law L>
class AlongYarn final : public Effect {
  using Slopes = typename L::Slopes;

 public:
  /// The law at `nodes` Gauss nodes of each of `segments`; the first and the last segment of a yarn take `end_nodes`
  /// if that is more, but in a periodic fabric, whose yarns have no ends. `parts` must outlive the effect's last use.
  AlongYarn(L law, const Parts& parts, int nodes, const std::vector<int>& segments, int end_nodes = 0)
      : law_(std::move(law)),
        parts_(parts),
        rules_{Rule(nodes), Rule(std::max(nodes, end_nodes))},
        blocks_(parts.fabric, segments, end_nodes > nodes && !parts.fabric.cell) {
    const std::vector<int>& all = blocks_.segments();
    for (const int segment : all) {
      constant_.push_back(law_.constant(parts_.fabric.material_of(segment)));
      l0_.push_back(parts_.fabric.segment(segment).length);
    }
    // The kernels read beyond the last segment.
    constant_.resize(all.size() + block_padding, 1);
    l0_.resize(all.size() + block_padding, 1);
    if constexpr (Remembers<L>) remember();
  }

  std::string_view name() const override { return law_.name(); }
  bool dissipative() const override { return !Slopes::elastic; }

  void add(const State& at, Load& out) const override {
    double* const scalar = Slopes::elastic ? out.energy : out.dissipation;
    if (scalar || out.force) add_slopes(at, scalar, out.force);
    add_second(at, Slopes::elastic ? out.stiffness : out.damping, false);
    if (Slopes::elastic) add_second(at, out.convex, true);
  }

 private:
  static constexpr std::size_t few = 256;  // segments for which threads cost more than they save

  struct Rule {
    std::vector<NodeWeights> nodes;
    explicit Rule(int count) {
      for (const GaussNode& node : gauss(count)) {
        const Basis b = basis(node.s);
        NodeWeights& of = nodes.emplace_back();
        of.weight = node.weight;
        std::copy(b.value.begin(), b.value.end(), of.value);
        std::copy(b.first.begin(), b.first.end(), of.first);
        std::copy(b.second.begin(), b.second.end(), of.second);
      }
    }
  };

  int first_point(std::size_t i) const { return parts_.fabric.first_point(blocks_.segments()[i]); }
  bool is_little() const { return blocks_.segments().size() < few; }
  const Rule& rule_of(const SegmentBlock& block) const { return rules_[block.at_end]; }
  std::size_t reference_stride() const { return blocks_.segments().size() + block_padding; }
  /// Where coordinate c of the reference of a node is kept, by segment.
  std::size_t reference(std::size_t node, std::size_t c) const { return (3 * node + c) * reference_stride(); }

  void remember() {
    reference_.resize(3 * rules_[1].nodes.size() * reference_stride());
    for (const SegmentBlock& block : blocks_.all())
      for (std::size_t i = block.begin; i < block.end(); ++i)
        for (std::size_t node = 0; node < rule_of(block).nodes.size(); ++node) {
          const Vec3 kept = law_.reference(parts_, first_point(i), rule_of(block).nodes[node]);
          for (std::size_t c = 0; c < 3; ++c) reference_[reference(node, c) + i] = kept[static_cast<Eigen::Index>(c)];
        }
  }

  void add_slopes(const State& at, double* scalar, Points* force) const {
    const Slopes slopes = law_.slopes(at.t);
    const RestLengths rest = parts_.rest(at.t);
    const AlongKernel<Slopes> kernel = kernels().along<Slopes>();
    std::vector<double> scalars(blocks_.all().size());
#pragma omp parallel if (!is_little())
    for (const auto& [first, last] : blocks_.colours()) {
#pragma omp for schedule(static)
      for (std::size_t i = first; i < last; ++i)
        scalars[i] = add_block(slopes, kernel, awake(blocks_.all()[i]), at, rest, force);
    }
    if (scalar)
      for (const double of : scalars) *scalar += of;
  }

  /// From the first segment of a block that does not sleep to the last.
  SegmentBlock awake(SegmentBlock block) const {
    if (Led<L> || parts_.asleep.empty()) return block;
    const auto sleeps = [this](std::size_t i) {
      return parts_.asleep[static_cast<std::size_t>(blocks_.segments()[i])] != 0;
    };
    while (block.count > 0 && sleeps(block.end() - 1)) --block.count;
    for (; block.count > 0 && sleeps(block.begin); ++block.begin) --block.count;
    return block;
  }

  /// A yarn lies within the box around its control points.
  bool is_out_of_reach(const Slopes& slopes, const SegmentBlock& of, const State& at) const {
    if constexpr (Local<L>) {
      const auto points = at.q.middleCols(first_point(of.begin), static_cast<Eigen::Index>(of.count) + 3);
      const Vec3 low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
      const auto constants = constant_.begin() + static_cast<std::ptrdiff_t>(of.begin);
      return !law_.reaches(slopes, (low + high) / 2, (high - low).norm() / 2,
                           *std::max_element(constants, constants + static_cast<std::ptrdiff_t>(of.count)));
    }
    return false;
  }

  double add_block(const Slopes& slopes, AlongKernel<Slopes> kernel, const SegmentBlock& of, const State& at,
                   const RestLengths& rest, Points* force) const {
    if (of.count == 0 || is_out_of_reach(slopes, of, at)) return 0;
    double l[block_length + block_padding];
    for (std::size_t i = 0; i < of.count; ++i) l[i] = rest.of(parts_.fabric.segment(blocks_.segments()[of.begin + i]));
    std::fill_n(l + of.count, block_padding, 1.0);
    const long first = 3 * static_cast<long>(first_point(of.begin));
    const Rule& rule = rule_of(of);
    AlongBlock block{.count = static_cast<int>(of.count),
                     .points = (Slopes::elastic ? at.q : at.v).data() + first,
                     .force = force ? force->data() + first : nullptr,
                     .l = l,
                     .l0 = l0_.data() + of.begin,
                     .constant = constant_.data() + of.begin,
                     .reference = Remembers<L> ? reference_.data() + of.begin : nullptr,
                     .reference_stride = static_cast<long>(reference_stride()),
                     .nodes = rule.nodes.data(),
                     .node_count = static_cast<int>(rule.nodes.size())};
    kernel(slopes, block);
    return Slopes::elastic ? block.energy : block.dissipation;
  }

  const std::vector<int>& places_in(Stiffness& matrix) const {
    return matrix.places(this, 0, [&](std::vector<int>& slots) {
      for (std::size_t i = 0; i < blocks_.segments().size(); ++i)
        for (int j = 0; j < 4; ++j) matrix.slots(first_point(i) + j, first_point(i) + j, 4 - j, slots);
    });
  }

  Site<double> site(const State& at, double rest_length, std::size_t i, std::size_t node, const Rule& rule) const {
    const NodeWeights& of = rule.nodes[node];
    const int first = first_point(i);
    Vector<double> kept;
    if constexpr (Remembers<L>)
      kept = {reference_[reference(node, 0) + i], reference_[reference(node, 1) + i],
              reference_[reference(node, 2) + i]};
    return {to_vector(combine(at.q, first, of.value)),
            to_vector(combine(at.q, first, of.first)),
            to_vector(combine(at.q, first, of.second)),
            to_vector(combine(at.v, first, of.value)),
            rest_length,
            l0_[i],
            constant_[i],
            kept};
  }

  void add_second(const State& at, Stiffness* out, bool convex) const {
    if (!out) return;
    const std::vector<int>& places = places_in(*out);
    const Slopes now = law_.slopes(at.t);
    const RestLengths rest = parts_.rest(at.t);
    // Where two threads meet, both ask the law about the segments that reach across.
    share_points(static_cast<int>(at.q.cols()), is_little(), [&](int from, int to) {
      for (const SegmentBlock& block : blocks_.all())
        for (std::size_t i = block.begin; i < block.end(); ++i)
          if (first_point(i) + 4 > from && first_point(i) < to)
            add_second(now, at, rest.of(parts_.fabric.segment(blocks_.segments()[i])), i, rule_of(block),
                       {std::max(from - first_point(i), 0), std::min(to - first_point(i), 4)}, convex, places, *out);
    });
  }

  /// Of the four control points of a segment: those that a thread adds to.
  struct Range {
    int from = 0, to = 0;
  };

  void add_second(const Slopes& now, const State& at, double rest_length, std::size_t i, const Rule& rule, Range mine,
                  bool convex, const std::vector<int>& places, Stiffness& out) const {
    // Blocks (j, k) with j <= k of the segment, row by row: so many lie before each row.
    constexpr std::array<std::size_t, 4> before{0, 4, 7, 9};
    for (std::size_t node = 0; node < rule.nodes.size(); ++node) {
      const NodeWeights& b = rule.nodes[node];
      const double w = b.weight;
      Curvature c;
      law_.curvature(now, site(at, rest_length, i, node, rule), c, convex);
      for (auto j = static_cast<std::size_t>(mine.from); j < static_cast<std::size_t>(mine.to); ++j) {
        std::size_t place = i * 10 + before[j];
        const Mat3 by_y = w * b.value[j] * (Slopes::elastic ? c.y_y : c.v_v);
        const Mat3 by_dy = w * (b.first[j] * c.dy_dy + b.second[j] * c.dy_ddy.transpose());
        const Mat3 by_ddy = w * (b.first[j] * c.dy_ddy + b.second[j] * c.ddy_ddy);
        for (std::size_t k = j; k < 4; ++k, ++place) {
          if constexpr (Slopes::derivative == 0) out.add_at(places[place], b.value[k] * by_y);
          if constexpr (Slopes::derivative == 1) out.add_at(places[place], b.first[k] * by_dy);
          if constexpr (Slopes::derivative == 2) out.add_at(places[place], b.first[k] * by_dy + b.second[k] * by_ddy);
        }
      }
    }
  }

  L law_;
  const Parts& parts_;
  std::array<Rule, 2> rules_;  // of most segments, of the ends of yarns
  SegmentBlocks blocks_;
  std::vector<double> constant_, l0_;  // by segment
  std::vector<double> reference_;      // by node, coordinate and segment
};

inline std::vector<int> all_segments(const Fabric& fabric) {
  std::vector<int> all(fabric.segments.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Those of a part of the fabric, ascending.
inline std::vector<int> segments_of(const Fabric& fabric, const Part& part) {
  std::vector<int> some = part.segments.empty() ? all_segments(fabric) : part.segments;
  const std::vector<int>& materials = part.materials;
  const auto is_other = [&](int i) {
    return std::find(materials.begin(), materials.end(), fabric.segment(i).material) == materials.end();
  };
  if (!materials.empty()) some.erase(std::remove_if(some.begin(), some.end(), is_other), some.end());
  return some;
}

}  // namespace wale
