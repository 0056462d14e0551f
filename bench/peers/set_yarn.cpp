#include "bench/peers/set_yarn.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "sim/cross_matrix.hpp"
#include "sim/spline.hpp"

namespace wale::peers {
namespace {

constexpr int nodes = 3;

Vec3 curvature_of(const Vec3& a, const Vec3& b) { return a.cross(b) / std::pow(a.norm(), 3); }

struct Node {
  double weight = 0;
  Basis basis;
};

std::vector<Node> node_bases() {
  std::vector<Node> found;
  for (const GaussNode& node : gauss(nodes)) found.push_back({node.weight, basis(node.s)});
  return found;
}

/// The force kernels take no law that remembers two vectors of a site, so this one goes segment by segment.
class SetYarn final : public Effect {
 public:
  explicit SetYarn(const Parts& parts) : parts_(parts) {
    for (int i = 0; i < parts.fabric.segment_count(); ++i)
      for (const Node& node : nodes_) {
        const int first = parts.fabric.first_point(i);
        const Vec3 dy = combine(parts.fabric.points, first, node.basis.first);
        laid_.push_back({dy.norm() / parts.fabric.segment(i).length, dy.normalized(),
                         curvature_of(dy, combine(parts.fabric.points, first, node.basis.second))});
      }
  }

  std::string_view name() const override { return "set yarn"; }

  void add(const State& at, Load& out) const override {
    const RestLengths rest = parts_.rest(at.t);
    auto laid = laid_.begin();
    for (int i = 0; i < parts_.fabric.segment_count(); ++i)
      for (const Node& node : nodes_) add_node(at, i, rest.of(parts_.fabric.segment(i)), node, *laid++, out);
  }

 private:
  struct Laid {
    double speed;  // over the segment's length
    Vec3 tangent, curvature;
  };

  /// `l`: the segment's rest length.
  void add_node(const State& at, int segment, double l, const Node& node, const Laid& of, Load& out) const {
    add_stretch(at, segment, l * of.speed, node, out);
    add_bend(at, segment, l, node, of, out);
  }

  /// `u`: the speed at rest.
  void add_stretch(const State& at, int segment, double u, const Node& node, Load& out) const {
    const int first = parts_.fabric.first_point(segment);
    const double EA = node.weight * parts_.fabric.material_of(segment).axial_stiffness;
    const Vec3 slope = combine(at.q, first, node.basis.first);
    const double length = slope.norm(), strain = length / u - 1;
    if (out.energy) *out.energy += EA * u * strain * strain / 2;
    if (out.force)
      for (int k = 0; k < 4; ++k)
        out.force->col(first + k) -= node.basis.first[static_cast<std::size_t>(k)] * EA * strain / length * slope;
    const Mat3 along = slope * slope.transpose() / (length * length), across = Mat3::Identity() - along;
    add_second(out.stiffness, first, node.basis.first, EA / u * along + EA * strain / length * across);
    add_second(out.convex, first, node.basis.first, EA / u * along + EA * std::max(strain, 0.0) / length * across);
  }

  static void add_second(Stiffness* out, int first, const std::array<double, 4>& by_point, const Mat3& second) {
    if (!out) return;
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = j; k < 4; ++k)
        out->add(first + static_cast<int>(j), first + static_cast<int>(k), by_point[j] * by_point[k] * second);
  }

  void add_bend(const State& at, int segment, double l, const Node& node, const Laid& of, Load& out) const {
    const int first = parts_.fabric.first_point(segment);
    const double scale = node.weight * parts_.fabric.material_of(segment).bending_rigidity * l * of.speed;
    const Vec3 a = combine(at.q, first, node.basis.first), b = combine(at.q, first, node.basis.second);
    const double length = a.norm(), p = 1 / (length * length * length);
    const Vec3 rest = of.curvature * parts_.fabric.segment(segment).length / l, t = a / length;
    // The smallest rotation of a vector across the old tangent.
    const double open = 1 + t.dot(of.tangent), share = t.dot(rest) / open;
    const Vec3 off = a.cross(b) * p - (rest - share * (of.tangent + t));
    if (out.energy) *out.energy += scale * off.squaredNorm() / 2;
    const Mat3 across = (Mat3::Identity() - t * t.transpose()) / length;
    const Mat3 share_by_t = (of.tangent + t) * (rest / open - share / open * of.tangent).transpose();
    const Mat3 by_a = -p * cross_matrix(b) - 3 * p / length * a.cross(b) * t.transpose() +
                      (share_by_t + share * Mat3::Identity()) * across;
    const Mat3 by_b = p * cross_matrix(a);
    Mat3 by_point[4];
    for (std::size_t k = 0; k < 4; ++k) by_point[k] = node.basis.first[k] * by_a + node.basis.second[k] * by_b;
    if (out.force)
      for (int k = 0; k < 4; ++k) out.force->col(first + k) -= scale * by_point[k].transpose() * off;
    for (Stiffness* second : {out.stiffness, out.convex})
      if (second)
        for (int j = 0; j < 4; ++j)
          for (int k = j; k < 4; ++k) second->add(first + j, first + k, scale * by_point[j].transpose() * by_point[k]);
  }

  const Parts& parts_;
  std::vector<Node> nodes_ = node_bases();
  std::vector<Laid> laid_;  // by site
};

}  // namespace

std::unique_ptr<Effect> set_yarn(const Parts& parts) { return std::make_unique<SetYarn>(parts); }

}  // namespace wale::peers
