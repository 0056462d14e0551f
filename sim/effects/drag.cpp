#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

/// D = k_g l |v|² (Ding et al. 2023, Eq. 16, with the factor l); the force is -2 k_g l v.
struct DragLaw {
  static constexpr bool elastic = false;
  static constexpr int derivative = 0;
  double k_g;
  std::string_view name() const { return "drag"; }

  void operator()(const Site& at, Slope& slope, Curvature* curvature, bool) const {
    const double k = k_g * at.l;
    slope.dissipation = k * at.v.squaredNorm();
    slope.v = 2 * k * at.v;
    if (curvature) curvature->v_v = 2 * k * Mat3::Identity();
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Drag& spec, Parts& parts) {
  // Four nodes integrate v·v exactly, so that a free yarn slows by one exponential.
  return std::make_unique<AlongYarn<DragLaw>>(DragLaw{spec.coefficient}, parts, 4, all_segments(parts.fabric));
}

}  // namespace wale
