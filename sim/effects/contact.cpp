#include "sim/effects/between_yarns.hpp"
#include "sim/effects/contact_law.hpp"

namespace wale {
namespace {

/// f(|y_a - y_b| / d), Ding et al. 2023, Eqs. (17)-(20).
struct Repulsion {
  static constexpr bool elastic = true;
  static constexpr bool by_kernels = true;
  bool inflate = false;
  std::string_view name() const { return "contact"; }
  double diameter(double d, double spacing_a, double spacing_b) const {
    return inflate ? (inflated_diameter(d, spacing_a) + inflated_diameter(d, spacing_b)) / 2 : d;
  }

  void operator()(const Touch& touch, Push& push, bool) const {
    const double square = touch.diameter * touch.diameter, squared_distance = touch.apart.squaredNorm();
    const Penalty f = penalty(*touch.a, *touch.b, squared_distance / square);
    push.on_a = -touch.weight * f.slope / square * touch.apart;
    const Mat3 normal = touch.apart * touch.apart.transpose() / squared_distance;
    push.convex = touch.weight * f.second / square * normal;
    // The push lets the beads slip sideways off each other: negative geometric stiffness.
    push.stiffness = push.convex + touch.weight * f.slope / square * (Mat3::Identity() - normal);
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Contact& spec, Parts& parts) {
  return std::make_unique<BetweenYarns<Repulsion>>(Repulsion{spec.inflate_beads}, parts,
                                                   parts.beads(spec.sampling, spec.screening, spec.skin));
}

}  // namespace wale
