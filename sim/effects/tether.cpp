#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

constexpr int nodes = 3;

/// k_t l0 |W (y - F(y_ref, t))|² (Ding et al. 2023, Eq. A.6; the factor l0 keeps it independent of the segment count).
struct TetherLaw {
  static constexpr bool elastic = true;
  static constexpr int derivative = 0;
  Tether spec;
  std::vector<Vec3> reference;  // y_ref by site
  std::string_view name() const { return spec.label; }

  Vec3 target(const Vec3& from, double t) const {
    const double p = spec.progress(t);
    const Vec3 scale = Vec3::Ones() + p * (spec.scale - Vec3::Ones());
    return spec.centre + scale.cwiseProduct(from - spec.centre) + p * spec.move;
  }

  void operator()(const Site& at, Slope& slope, Curvature* curvature, bool) const {
    const double k = spec.stiffness * at.l0;
    const Vec3 weight = spec.axes.cwiseAbs2();
    const Vec3 off = at.y - target(reference[static_cast<std::size_t>(at.index)], at.t);
    slope.energy = k * off.dot(weight.cwiseProduct(off));
    slope.y = 2 * k * weight.cwiseProduct(off);
    if (curvature) curvature->y_y = (2 * k * weight).asDiagonal();
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Tether& spec, Parts& parts) {
  TetherLaw law{spec, {}};
  for (const int segment : spec.segments)
    for (const GaussNode& node : gauss(nodes))
      law.reference.push_back(combine(parts.start.q, parts.fabric.first_point(segment), basis(node.s).value));
  return std::make_unique<AlongYarn<TetherLaw>>(std::move(law), parts, nodes, spec.segments);
}

}  // namespace wale
