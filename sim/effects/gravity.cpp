#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

struct GravityEffect {
  using Slopes = GravityLaw;
  Vec3 g;
  std::string_view name() const { return "gravity"; }
  GravityLaw slopes(double) const { return {to_vector(g)}; }
  double constant(const Material& yarn) const { return yarn.linear_density; }
  void curvature(const Slopes&, const Site<double>&, Curvature&, bool) const {}
};

}  // namespace

std::unique_ptr<Effect> make(const Gravity& spec, Parts& parts) {
  return std::make_unique<AlongYarn<GravityEffect>>(GravityEffect{spec.acceleration}, parts, 2,
                                                    segments_of(parts.fabric, spec.on));
}

}  // namespace wale
