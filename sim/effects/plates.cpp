#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

struct PlatesEffect {
  using Slopes = PlatesLaw;
  double stiffness, gap;
  std::string_view name() const { return "plates"; }
  PlatesLaw slopes(double) const { return {stiffness, gap}; }
  double constant(const Material&) const { return 0; }
  void curvature(const Slopes&, const Site<double>& at, Curvature& out, bool) const {
    if (std::abs(at.y.z) > gap / 2) out.y_y(2, 2) = 2 * stiffness * at.l0;
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Plates& spec, Parts& parts) {
  return std::make_unique<AlongYarn<PlatesEffect>>(PlatesEffect{spec.stiffness, spec.gap}, parts, 2,
                                                   all_segments(parts.fabric));
}

}  // namespace wale
