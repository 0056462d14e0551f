#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

struct StretchEffect {
  using Slopes = StretchLaw;
  std::string_view name() const { return "stretch"; }
  StretchLaw slopes(double) const { return {}; }
  double constant(const Material& yarn) const { return yarn.axial_stiffness; }

  void curvature(const Slopes&, const Site<double>& at, Curvature& out, bool convex) const {
    const double EA = at.constant;
    const Vec3 slope = to_vec3(at.dy);
    const double length = slope.norm();
    const double strain = length / at.l - 1;
    const Vec3 along = slope / length;
    const Mat3 lengthwise = along * along.transpose();
    // A slack yarn would buckle sideways: negative geometric stiffness.
    const double tension = convex ? std::max(strain, 0.0) : strain;
    out.dy_dy = EA / at.l * lengthwise + EA * tension / length * (Mat3::Identity() - lengthwise);
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Stretch& spec, Parts& parts) {
  // One node a segment leaves y' free to vanish at a yarn's end, where only one segment holds the last control point.
  constexpr int end_nodes = 3;
  return std::make_unique<AlongYarn<StretchEffect>>(StretchEffect{}, parts, spec.nodes, all_segments(parts.fabric),
                                                    end_nodes);
}

}  // namespace wale
