#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

constexpr int nodes = 3;

struct ObstacleEffect {
  using Slopes = ObstacleLaw;
  Obstacle spec;
  std::string_view name() const { return spec.label; }
  double constant(const Material& yarn) const { return yarn.diameter / 2; }

  ObstacleLaw slopes(double t) const {
    return {spec.stiffness,
            to_vector(spec.centre + spec.progress(t) * spec.move),
            to_vector(spec.axis),
            spec.radius,
            spec.shape == Obstacle::Shape::plane,
            spec.shape == Obstacle::Shape::cylinder};
  }

  bool reaches(const ObstacleLaw& now, const Vec3& centre, double radius, double half_diameter) const {
    Site<double> at;
    at.y = to_vector(centre);
    at.constant = half_diameter + radius;
    return now.touch(at).depth > 0;
  }

  void curvature(const ObstacleLaw& now, const Site<double>& at, Curvature& out, bool convex) const {
    const ObstacleLaw::Touch<double> of = now.touch(at);
    if (of.depth <= 0) return;
    const double k = 2 * now.stiffness * at.l0;
    const Vec3 away = to_vec3(of.away), axis = to_vec3(now.axis);
    const Mat3 outwards = away * away.transpose();
    out.y_y = k * outwards;
    if (now.flat || convex) return;
    // A round body lets go of a yarn that moves sideways.
    const Mat3 all = Mat3::Identity() - (now.endless ? 1.0 : 0.0) * axis * axis.transpose();
    out.y_y -= k * of.depth / of.distance * (all - outwards);
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Obstacle& spec, Parts& parts) {
  return std::make_unique<AlongYarn<ObstacleEffect>>(ObstacleEffect{spec}, parts, nodes,
                                                     segments_of(parts.fabric, spec.on));
}

}  // namespace wale
