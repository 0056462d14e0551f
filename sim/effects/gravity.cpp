#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

/// -rho l0 y·g (Ding et al. 2023, Eq. 15, sign corrected; the mass is that of the yarn as laid).
struct GravityLaw {
  static constexpr bool elastic = true;
  static constexpr int derivative = 0;
  Vec3 g;
  std::string_view name() const { return "gravity"; }

  void operator()(const Site& at, Slope& slope, Curvature*, bool) const {
    const double mass = at.yarn->linear_density * at.l0;
    slope.energy = -mass * at.y.dot(g);
    slope.y = -mass * g;
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Gravity& spec, Parts& parts) {
  return std::make_unique<AlongYarn<GravityLaw>>(GravityLaw{spec.acceleration}, parts, 2, all_segments(parts.fabric));
}

}  // namespace wale
