#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

/// ½ EA l (|y'|/l - 1)², Ding et al. 2023, Eq. (12).
struct StretchLaw {
  static constexpr bool elastic = true;
  static constexpr int derivative = 1;
  std::string_view name() const { return "stretch"; }

  void operator()(const Site& at, Slope& slope, Curvature* curvature, bool convex) const {
    const double EA = at.yarn->axial_stiffness;
    const double length = at.dy.norm();
    const double strain = length / at.l - 1;
    const Vec3 along = at.dy / length;

    slope.energy = EA * at.l * strain * strain / 2;
    slope.dy = EA * strain * along;
    if (!curvature) return;
    const Mat3 lengthwise = along * along.transpose();
    // A slack yarn would buckle sideways: negative geometric stiffness.
    const double tension = convex ? std::max(strain, 0.0) : strain;
    curvature->dy_dy = EA / at.l * lengthwise + EA * tension / length * (Mat3::Identity() - lengthwise);
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Stretch& spec, Parts& parts) {
  // One node a segment leaves y' free to vanish at a yarn's end, where only one segment holds the last control point.
  constexpr int end_nodes = 3;
  return std::make_unique<AlongYarn<StretchLaw>>(StretchLaw{}, parts, spec.nodes, all_segments(parts.fabric),
                                                 end_nodes);
}

}  // namespace wale
