#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

struct DragEffect {
  using Slopes = DragLaw;
  double k_g;
  std::string_view name() const { return "drag"; }
  DragLaw slopes(double) const { return {k_g}; }
  double constant(const Material&) const { return 0; }
  void curvature(const Slopes&, const Site<double>& at, Curvature& out, bool) const {
    out.v_v = 2 * k_g * at.l * Mat3::Identity();
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Drag& spec, Parts& parts) {
  // Four nodes integrate v·v exactly, so that a free yarn slows by one exponential.
  return std::make_unique<AlongYarn<DragEffect>>(DragEffect{spec.coefficient}, parts, 4,
                                                 segments_of(parts.fabric, spec.on));
}

}  // namespace wale
