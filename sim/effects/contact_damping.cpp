#include "sim/effects/between_yarns.hpp"

namespace wale {
namespace {

/// k_dt |Δv|² - (k_dt - k_dn)(n·Δv)² where beads overlap (Ding et al. 2023, Eqs. 19, 21); the force has a factor 2.
struct ViscousTouch {
  static constexpr bool elastic = false;
  static constexpr bool by_kernels = false;
  double tangential, normal;
  std::string_view name() const { return "contact_damping"; }
  double diameter(double d, double, double) const { return d; }

  void operator()(const Touch& touch, Push& push, bool second) const {
    const Vec3 n = touch.apart.normalized();
    const double along = n.dot(touch.velocity);
    const double difference = tangential - normal;
    push.dissipation = touch.weight * (tangential * touch.velocity.squaredNorm() - difference * along * along);
    push.on_a = -2 * touch.weight * (tangential * touch.velocity - difference * along * n);
    if (second) push.stiffness = 2 * touch.weight * (tangential * Mat3::Identity() - difference * n * n.transpose());
  }
};

}  // namespace

std::unique_ptr<Effect> make(const ContactDamping& spec, Parts& parts) {
  return std::make_unique<BetweenYarns<ViscousTouch>>(ViscousTouch{spec.tangential, spec.normal}, parts,
                                                      parts.dissipative_beads(spec.sampling, spec.screening, spec.skin));
}

}  // namespace wale
