#include <Eigen/Geometry>
#include <cmath>

#include "sim/cross_matrix.hpp"
#include "sim/parts.hpp"
#include "sim/spline.hpp"
#include "sim/turns.hpp"

namespace wale {
namespace {

/// Two control points, by their weight c in the area A = Σ c (q_j × q_k)·axis.
struct Pair {
  int j = 0, k = 0;
  double weight = 0;
};

/// Of each two of a segment's control points: ½ ∫ (b_j b_k' - b_k b_j') ds. Degree 5: three Gauss nodes are exact.
Eigen::Matrix4d area_weights() {
  Eigen::Matrix4d weights = Eigen::Matrix4d::Zero();
  for (const GaussNode& node : gauss(3)) {
    const Basis at = basis(node.s);
    const Eigen::Map<const Eigen::Vector4d> value(at.value.data()), first(at.first.data());
    weights += node.weight / 2 * (value * first.transpose() - first * value.transpose());
  }
  return weights;
}

/// The area that a yarn encloses, its ends joined by a straight line: then it is the same wherever the yarn lies.
void list_pairs(const Yarn& yarn, std::vector<Pair>& pairs) {
  static const Eigen::Matrix4d weights = area_weights();
  const int last = yarn.first_point + yarn.segments - 1;  // the first control point of the last segment
  for (int first = yarn.first_point; first <= last; ++first)
    for (int j = 0; j < 4; ++j)
      for (int k = j + 1; k < 4; ++k) pairs.push_back({first + j, first + k, weights(j, k)});
  const Basis start = basis(0), end = basis(1);
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k = 0; k < 4; ++k)
      pairs.push_back(
          {last + static_cast<int>(j), yarn.first_point + static_cast<int>(k), end.value[j] * start.value[k] / 2});
}

class PressureEffect final : public Effect {
 public:
  PressureEffect(const Pressure& spec, const Parts& parts) : spec_(spec) {
    const Turns of = turns_about(parts.fabric, parts.start.q, spec.axis);
    height_ = std::copysign(spec.spacing > 0 ? spec.spacing : of.extent / std::abs(of.count), of.count);
    for (const Yarn& yarn : parts.fabric.yarns) list_pairs(yarn, pairs_);
  }

  std::string_view name() const override { return "pressure"; }

  void add(const State& at, Load& out) const override {
    const double push = (spec_.from + spec_.progress(at.t) * (spec_.to - spec_.from)) * height_;
    const Vec3& a = spec_.axis;
    const Mat3 across = cross_matrix(a);
    for (const Pair& pair : pairs_) {
      const Vec3 qj = at.q.col(pair.j), qk = at.q.col(pair.k);
      const double c = push * pair.weight;
      if (out.energy) *out.energy -= c * a.dot(qj.cross(qk));
      if (out.force) {
        out.force->col(pair.j) += c * qk.cross(a);
        out.force->col(pair.k) += c * a.cross(qj);
      }
      // Nothing of it is convex.
      if (out.stiffness) add_second(pair, c * across, *out.stiffness);
    }
  }

 private:
  /// `second` is that by q_j (rows) and q_k of -c (q_j × q_k)·axis.
  static void add_second(const Pair& pair, const Mat3& second, Stiffness& out) {
    if (pair.j < pair.k) out.add(pair.j, pair.k, second);
    if (pair.j > pair.k) out.add(pair.k, pair.j, second.transpose());
  }

  Pressure spec_;
  double height_;  // of a turn, m; negative if the yarns go around the axis the other way
  std::vector<Pair> pairs_;
};

}  // namespace

std::unique_ptr<Effect> make(const Pressure& spec, Parts& parts) {
  return std::make_unique<PressureEffect>(spec, parts);
}

}  // namespace wale
