#include <Eigen/Geometry>

#include "sim/cross_matrix.hpp"
#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

constexpr int nodes = 3;

/// A node of the quadrature where the stage begins: the tangent t_0, and t_0' × t_0.
struct Reference {
  Vec3 tangent, turning;
};

Reference reference(const Vec3& dy, const Vec3& ddy) {
  const double length = dy.norm();
  const Vec3 tangent = dy / length;
  const Vec3 change = (ddy - tangent.dot(ddy) * tangent) / length;
  return {tangent, change.cross(tangent)};
}

/// 2π (Wr - Wr_0) per unit of s, a function of a = y' and b = y'' (Fuller 1978, Eq. 6.4):
/// (t_0 × t)·(t_0' + t') / (1 + t_0·t) = (t_0·(a × b)/|a| + a·(t_0' × t_0)) / (|a| + t_0·a).
/// It knows the writhe up to where a tangent has turned to the opposite of what it was.
struct Writhing {
  double value;
  Vec3 by_a, by_b;
  Mat3 by_aa, by_ab;  ///< rows by a

  Writhing(const Reference& from, const Vec3& a, const Vec3& b) {
    const Vec3& t0 = from.tangent;
    const double n = a.norm(), n3 = n * n * n, P = t0.dot(a.cross(b)), D = n + t0.dot(a);
    const Vec3 P_a = b.cross(t0), P_b = t0.cross(a), D_a = a / n + t0;
    const Mat3 one = Mat3::Identity(), aa = a * a.transpose();
    value = (P / n + a.dot(from.turning)) / D;
    by_a = (P_a / n - P / n3 * a + from.turning - value * D_a) / D;
    by_b = P_b / (n * D);
    by_aa = (-(P_a * a.transpose() + a * P_a.transpose()) / n3 - P / n3 * (one - 3 / (n * n) * aa) -
             by_a * D_a.transpose() - D_a * by_a.transpose() - value / n * (one - aa / (n * n))) /
            D;
    by_ab = (-cross_matrix(t0) / n - a * P_b.transpose() / n3 - D_a * by_b.transpose()) / D;
  }
};

class TwistEffect final : public Effect {
 public:
  TwistEffect(const Twist& spec, const Parts& parts)
      : spec_(spec), fabric_(parts.fabric), segments_(segments_of(parts.fabric, {spec.materials, {}})) {
    for (const GaussNode& node : gauss(nodes)) {
      rule_.push_back({node.weight, basis(node.s)});
    }
    for (const int segment : segments_)
      for (const Node& node : rule_) {
        const int first = fabric_.first_point(segment);
        references_.push_back(
            reference(combine(parts.start.q, first, node.at.first), combine(parts.start.q, first, node.at.second)));
      }
  }

  std::string_view name() const override { return "twist"; }

  void add(const State& at, Load& out) const override {
    if (!out.energy && !out.force && !out.stiffness) return;
    const double moment = spec_.from + spec_.progress(at.t) * (spec_.to - spec_.from);
    const std::vector<int>* places = out.stiffness ? &places_in(*out.stiffness) : nullptr;
    for (std::size_t i = 0; i < segments_.size(); ++i)
      for (std::size_t n = 0; n < rule_.size(); ++n) {
        const int first = fabric_.first_point(segments_[i]);
        const Basis& b = rule_[n].at;
        const double weight = -moment * rule_[n].weight;
        const Writhing of(references_[i * rule_.size() + n], combine(at.q, first, b.first),
                          combine(at.q, first, b.second));
        if (out.energy) *out.energy += weight * of.value;
        if (out.force)
          for (std::size_t k = 0; k < 4; ++k)
            out.force->col(first + static_cast<int>(k)) -= weight * (b.first[k] * of.by_a + b.second[k] * of.by_b);
        // Nothing of it is convex.
        if (places) add_second(of, b, weight, places->data() + 10 * i, *out.stiffness);
      }
  }

 private:
  struct Node {
    double weight;
    Basis at;
  };

  /// `place`: of blocks (j, k), j <= k, of the segment, row by row.
  static void add_second(const Writhing& of, const Basis& b, double weight, const int* place, Stiffness& out) {
    for (std::size_t j = 0; j < 4; ++j) {
      const Mat3 by_dy = weight * (b.first[j] * of.by_aa + b.second[j] * of.by_ab.transpose());
      const Mat3 by_ddy = weight * b.first[j] * of.by_ab;
      for (std::size_t k = j; k < 4; ++k) out.add_at(*place++, b.first[k] * by_dy + b.second[k] * by_ddy);
    }
  }

  const std::vector<int>& places_in(Stiffness& matrix) const {
    return matrix.places(this, 0, [&](std::vector<int>& slots) {
      for (const int segment : segments_)
        for (int j = 0; j < 4; ++j)
          matrix.slots(fabric_.first_point(segment) + j, fabric_.first_point(segment) + j, 4 - j, slots);
    });
  }

  Twist spec_;
  const Fabric& fabric_;
  std::vector<int> segments_;
  std::vector<Node> rule_;
  std::vector<Reference> references_;  // by segment and node
};

}  // namespace

std::unique_ptr<Effect> make(const Twist& spec, Parts& parts) { return std::make_unique<TwistEffect>(spec, parts); }

}  // namespace wale
