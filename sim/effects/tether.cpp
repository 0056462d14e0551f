#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

constexpr int nodes = 3;

struct TetherEffect {
  using Slopes = TetherLaw;
  Tether spec;
  std::string_view name() const { return spec.label; }
  Vec3 weight() const { return spec.axes.cwiseAbs2(); }
  double constant(const Material&) const { return 0; }
  Vec3 reference(const Parts& parts, int first_point, const NodeWeights& node) const {
    return combine(parts.start.q, first_point, node.value) - spec.centre;
  }

  TetherLaw slopes(double t) const {
    const double p = spec.progress(t);
    const Vec3 scale = Vec3::Ones() + p * (spec.scale - Vec3::Ones()), place = spec.centre + p * spec.move;
    return {spec.stiffness, to_vector(weight()), to_vector(scale), to_vector(place)};
  }
  void curvature(const Slopes&, const Site<double>& at, Curvature& out, bool) const {
    out.y_y = (2 * spec.stiffness * at.l0 * weight()).asDiagonal();
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Tether& spec, Parts& parts) {
  return std::make_unique<AlongYarn<TetherEffect>>(TetherEffect{spec}, parts, nodes, spec.segments);
}

}  // namespace wale
