#include <Eigen/Geometry>

#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

struct BendEffect {
  using Slopes = BendLaw;
  std::string_view name() const { return "bend"; }
  BendLaw slopes(double) const { return {}; }
  double constant(const Material& yarn) const { return yarn.bending_rigidity; }

  void curvature(const Site<double>& at, Curvature& out, bool convex) const {
    const double scale = at.constant * at.l;
    const Vec3 a = to_vec3(at.dy), b = to_vec3(at.ddy);
    if (convex)
      gauss_newton(scale, a, b, out);
    else
      exact(scale, a, b, out);
  }

  /// JᵀJ of the curvature vector a × b / |a|³, of which κ is the length.
  static void gauss_newton(double scale, const Vec3& a, const Vec3& b, Curvature& out) {
    const double aa = a.squaredNorm(), p = 1 / (aa * std::sqrt(aa));
    const Mat3 by_a = -p * cross_matrix(b) - 3 * p / aa * a.cross(b) * a.transpose();
    const Mat3 by_b = p * cross_matrix(a);
    out.dy_dy = scale * by_a.transpose() * by_a;
    out.dy_ddy = scale * by_a.transpose() * by_b;
    out.ddy_ddy = scale * by_b.transpose() * by_b;
  }

  static void exact(double scale, const Vec3& a, const Vec3& b, Curvature& out) {
    const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b), area = aa * bb - ab * ab;
    const double p3 = 1 / (aa * aa * aa), p4 = p3 / aa, p5 = p4 / aa;
    const Mat3 one = Mat3::Identity();
    const Vec3 area_a = 2 * (bb * a - ab * b), area_b = 2 * (aa * b - ab * a);
    const Mat3 area_aa = 2 * (bb * one - b * b.transpose());
    const Mat3 area_ab = 2 * (2 * a * b.transpose() - b * a.transpose() - ab * one);
    const Mat3 area_bb = 2 * (aa * one - a * a.transpose());
    out.dy_dy = scale / 2 *
                (area_aa * p3 - 6 * p4 * (area_a * a.transpose() + a * area_a.transpose()) - 6 * area * p4 * one +
                 48 * area * p5 * a * a.transpose());
    out.dy_ddy = scale / 2 * (area_ab * p3 - 6 * p4 * a * area_b.transpose());
    out.ddy_ddy = scale / 2 * area_bb * p3;
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Bend& spec, Parts& parts) {
  return std::make_unique<AlongYarn<BendEffect>>(BendEffect{}, parts, spec.nodes, all_segments(parts.fabric));
}

}  // namespace wale
