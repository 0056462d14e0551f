#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

/// k_p l0 max(0, |z| - gap/2)².
struct PlatesLaw {
  static constexpr bool elastic = true;
  static constexpr int derivative = 0;
  double stiffness, gap;
  std::string_view name() const { return "plates"; }

  void operator()(const Site& at, Slope& slope, Curvature* curvature, bool) const {
    const double depth = std::abs(at.y.z()) - gap / 2;
    if (depth <= 0) return;
    const double k = stiffness * at.l0;
    slope.energy = k * depth * depth;
    slope.y.z() = std::copysign(2 * k * depth, at.y.z());
    if (curvature) curvature->y_y(2, 2) = 2 * k;
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Plates& spec, Parts& parts) {
  return std::make_unique<AlongYarn<PlatesLaw>>(PlatesLaw{spec.stiffness, spec.gap}, parts, 2,
                                                all_segments(parts.fabric));
}

}  // namespace wale
