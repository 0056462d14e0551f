#include "bench/peers/set_yarn.hpp"

#include <Eigen/Geometry>

#include "sim/effects/along_yarn.hpp"

namespace wale::peers {
namespace {

constexpr int nodes = 3;

Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

Vec3 curvature_of(const Vec3& a, const Vec3& b) { return a.cross(b) / std::pow(a.norm(), 3); }

struct SetYarnLaw {
  static constexpr bool elastic = true;
  static constexpr int derivative = 2;
  struct Laid {
    Vec3 tangent, curvature;
  };
  std::vector<Laid> laid;  // by site
  std::string_view name() const { return "bend"; }

  void operator()(const Site& at, Slope& slope, Curvature* curvature, bool) const {
    const double scale = at.yarn->bending_rigidity * at.l;
    const Vec3 &a = at.dy, &b = at.ddy;
    const double length = a.norm(), p = 1 / (length * length * length);
    const Laid& of = laid[static_cast<std::size_t>(at.index)];
    const Vec3 rest = of.curvature * at.l0 / at.l, t = a / length;
    // The smallest rotation of a vector across the old tangent.
    const double open = 1 + t.dot(of.tangent), share = t.dot(rest) / open;
    const Vec3 off = a.cross(b) * p - (rest - share * (of.tangent + t));
    const Mat3 across = (Mat3::Identity() - t * t.transpose()) / length;
    const Mat3 share_by_t = (of.tangent + t) * (rest / open - share / open * of.tangent).transpose();
    const Mat3 by_a = -p * cross_matrix(b) - 3 * p / length * a.cross(b) * t.transpose() +
                      (share_by_t + share * Mat3::Identity()) * across;
    const Mat3 by_b = p * cross_matrix(a);
    slope.energy = scale * off.squaredNorm() / 2;
    slope.dy = scale * by_a.transpose() * off;
    slope.ddy = scale * by_b.transpose() * off;
    if (!curvature) return;
    curvature->dy_dy = scale * by_a.transpose() * by_a;
    curvature->dy_ddy = scale * by_a.transpose() * by_b;
    curvature->ddy_ddy = scale * by_b.transpose() * by_b;
  }
};

}  // namespace

std::unique_ptr<Effect> set_yarn(const Parts& parts) {
  SetYarnLaw law;
  for (int i = 0; i < parts.fabric.segment_count(); ++i)
    for (const GaussNode& node : gauss(nodes)) {
      const Basis b = basis(node.s);
      const Vec3 dy = combine(parts.fabric.points, parts.fabric.first_point(i), b.first);
      law.laid.push_back(
          {dy.normalized(), curvature_of(dy, combine(parts.fabric.points, parts.fabric.first_point(i), b.second))});
    }
  return std::make_unique<AlongYarn<SetYarnLaw>>(std::move(law), parts, nodes, all_segments(parts.fabric));
}

}  // namespace wale::peers
