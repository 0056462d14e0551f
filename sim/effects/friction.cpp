#include <cmath>

#include "sim/effects/between_yarns.hpp"
#include "sim/effects/contact_law.hpp"

namespace wale {
namespace {

/// Coulomb's law, smoothed as in incremental potential contact (Li et al. 2020): D = µ N f(|v_t|), where f' rises from
/// 0 to 1 as |v_t| rises to the threshold. The power lost is between 2 D, far below it, and D, far above. N is what the
/// contact law gives for the two beads.
struct Rubbing {
  static constexpr bool elastic = false;
  static constexpr bool by_kernels = false;
  double coefficient, threshold;
  std::string_view name() const { return "friction"; }
  double diameter(double d, double, double) const { return d; }

  void operator()(const Touch& touch, Push& push, bool second) const {
    const double distance = touch.apart.norm();
    const Vec3 n = touch.apart / distance;
    const double delta = distance / touch.diameter;
    const double press = -delta * penalty(*touch.a, *touch.b, delta * delta).slope;
    const double most = coefficient * touch.weight * press / touch.diameter;  // µ N
    const Vec3 sliding = touch.velocity - n.dot(touch.velocity) * n;
    const double speed = sliding.norm(), x = std::min(speed / threshold, 1.0);
    push.dissipation = most * (x < 1 ? threshold * x * x * (1 - x / 3) : speed - threshold / 3);
    const double slope = x < 1 ? (2 - x) / threshold : 1 / speed;  // f'(|v|) / |v|
    push.on_a = -most * slope * sliding;
    if (!second) return;
    const Mat3 tangent = Mat3::Identity() - n * n.transpose();
    push.stiffness = most * slope * tangent;
    if (speed == 0) return;
    const Vec3 along = sliding / speed;
    const double steepening = x < 1 ? 2 * (1 - x) / threshold : 0;  // f''
    push.stiffness += (1 - touch.secant) * most * (steepening - slope) * along * along.transpose();
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Friction& spec, Parts& parts) {
  return std::make_unique<BetweenYarns<Rubbing>>(Rubbing{spec.coefficient, spec.threshold}, parts,
                                                 parts.dissipative_beads(spec.sampling, spec.screening, spec.skin));
}

}  // namespace wale
