#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sim/cross_matrix.hpp"
#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

/// JᵀJ of the curvature vector a × b / |a|³, of which κ is the length.
void gauss_newton(double scale, const Vec3& a, const Vec3& b, Curvature& out) {
  const double aa = a.squaredNorm(), p = 1 / (aa * std::sqrt(aa));
  const Mat3 by_a = -p * cross_matrix(b) - 3 * p / aa * a.cross(b) * a.transpose();
  const Mat3 by_b = p * cross_matrix(a);
  out.dy_dy = scale * by_a.transpose() * by_a;
  out.dy_ddy = scale * by_a.transpose() * by_b;
  out.ddy_ddy = scale * by_b.transpose() * by_b;
}

/// u = κ² with its slopes by a = y' and b = y''.
struct SquaredCurvature {
  double value;
  Vec3 by_a, by_b;

  SquaredCurvature(const Vec3& a, const Vec3& b) {
    const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b), area = aa * bb - ab * ab;
    const double p3 = 1 / (aa * aa * aa), p4 = p3 / aa;
    value = area * p3;
    by_a = 2 * (bb * a - ab * b) * p3 - 6 * area * p4 * a;
    by_b = 2 * (aa * b - ab * a) * p3;
  }
};

/// Of ½ scale u.
void exact(double scale, const Vec3& a, const Vec3& b, Curvature& out) {
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

void add_squares(double weight, const SquaredCurvature& u, Curvature& out) {
  out.dy_dy += weight * u.by_a * u.by_a.transpose();
  out.dy_ddy += weight * u.by_a * u.by_b.transpose();
  out.ddy_ddy += weight * u.by_b * u.by_b.transpose();
}

struct BendEffect {
  using Slopes = BendLaw;
  std::string_view name() const { return "bend"; }
  BendLaw slopes(double) const { return {}; }
  double constant(const Material& yarn) const { return yarn.bending_rigidity; }

  void curvature(const Slopes&, const Site<double>& at, Curvature& out, bool convex) const {
    const double scale = at.constant * at.l;
    const Vec3 a = to_vec3(at.dy), b = to_vec3(at.ddy);
    if (convex)
      gauss_newton(scale, a, b, out);
    else
      exact(scale, a, b, out);
  }
};

struct SetBendEffect {
  using Slopes = SetBendLaw;
  std::string_view name() const { return "bend"; }
  SetBendLaw slopes(double) const { return {}; }
  double constant(const Material& yarn) const { return yarn.bending_rigidity; }

  /// κ as the compiler laid the yarn.
  Vec3 reference(const Parts& parts, int first_point, const NodeWeights& node) const {
    const Points& q = parts.fabric.points;
    const SquaredCurvature u(combine(q, first_point, node.first), combine(q, first_point, node.second));
    return {std::sqrt(std::max(u.value, 0.0)), 0, 0};
  }

  void curvature(const Slopes&, const Site<double>& at, Curvature& out, bool convex) const {
    const double scale = at.constant * at.l;
    const Vec3 a = to_vec3(at.dy), b = to_vec3(at.ddy);
    const SquaredCurvature u(a, b);
    const auto of = SetBendLaw::by_u(at, u.value);
    if (convex) {
      gauss_newton(scale * std::max(of.first, 0.0), a, b, out);
      // Along the curvature vector the energy bends by first + 2 u second, of which the line above has its share.
      const double along = std::max(of.first + 2 * u.value * of.second, 0.0) - std::max(of.first, 0.0);
      if (of.second > 0 && u.value > 0) add_squares(scale * along / (4 * u.value), u, out);
    } else {
      exact(scale * of.first, a, b, out);
      if (of.second > 0) add_squares(scale / 2 * of.second, u, out);
    }
  }
};

}  // namespace

std::unique_ptr<Effect> make(const Bend& spec, Parts& parts) {
  const std::vector<int> all = all_segments(parts.fabric);
  if (spec.rest == RestShape::as_laid)
    return std::make_unique<AlongYarn<SetBendEffect>>(SetBendEffect{}, parts, spec.nodes, all);
  return std::make_unique<AlongYarn<BendEffect>>(BendEffect{}, parts, spec.nodes, all);
}

}  // namespace wale
