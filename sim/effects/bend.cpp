#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sim/effects/along_yarn.hpp"

namespace wale {
namespace {

Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

// The corner of (κ - κ_0)² at κ = 0 is rounded over this share of κ_0.
constexpr double rounding = 0.1;

double squared_curvature(const Vec3& dy, const Vec3& ddy) {
  const double aa = dy.squaredNorm(), ab = dy.dot(ddy);
  return (aa * ddy.squaredNorm() - ab * ab) / (aa * aa * aa);
}

/// ½ EI l (κ - κ_0)², with κ = |y' × y''| / |y'|³ (Ding et al. 2023, Eqs. 13, 14), as a function of u = κ².
///
/// (κ - κ_0)² has a corner at κ = 0. With ε = κ_0 / 10, c = √(κ_0² + ε²) and r = √(u + ε²) it becomes
/// u - κ_0² - 2c (r - c): smooth, zero with its slope at κ = κ_0, and exactly κ² for a straight yarn.
struct BendLaw {
  static constexpr bool elastic = true;
  static constexpr int derivative = 2;
  std::vector<double> rest;  // κ_0 as laid by site, 1/m; empty for a straight yarn
  std::string_view name() const { return "bend"; }

  /// Of the energy over ½ EI l.
  struct ByU {
    double value = 0, first = 1, second = 0;
  };

  ByU by_u(const Site& at, double u) const {
    // A yarn that shrinks keeps its turn from point to point, so that its rest shape shrinks with it.
    const double rest_now = rest.empty() ? 0 : rest[static_cast<std::size_t>(at.index)] * at.l0 / at.l;
    if (rest_now == 0) return {u, 1, 0};
    const double e = rounding * rest_now, c = std::sqrt(rest_now * rest_now + e * e), r = std::sqrt(u + e * e);
    return {u - rest_now * rest_now - 2 * c * (r - c), 1 - c / r, c / (2 * r * r * r)};
  }

  void operator()(const Site& at, Slope& slope, Curvature* curvature, bool convex) const {
    const double scale = at.yarn->bending_rigidity * at.l;
    const Vec3 &a = at.dy, &b = at.ddy;
    const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b);
    const double area = aa * bb - ab * ab;  // |a × b|²
    const double p3 = 1 / (aa * aa * aa), p4 = p3 / aa;
    const ByU f = by_u(at, area * p3);

    slope.energy = scale * f.value / 2;
    const Vec3 area_a = 2 * (bb * a - ab * b), area_b = 2 * (aa * b - ab * a);
    const Vec3 u_a = area_a * p3 - 6 * area * p4 * a, u_b = area_b * p3;
    slope.dy = scale / 2 * f.first * u_a;
    slope.ddy = scale / 2 * f.first * u_b;
    if (!curvature) return;
    if (convex) {
      gauss_newton(scale * std::max(f.first, 0.0), a, b, *curvature);
      // Along the curvature vector the energy bends by first + 2 u second, of which the line above has its share.
      const double along = std::max(f.first + 2 * area * p3 * f.second, 0.0) - std::max(f.first, 0.0);
      if (f.second > 0 && area > 0) add_squares(scale * along / (4 * area * p3), u_a, u_b, *curvature);
    } else {
      exact(scale * f.first, at, *curvature);
      if (f.second > 0) add_squares(scale / 2 * f.second, u_a, u_b, *curvature);
    }
  }

  static void add_squares(double weight, const Vec3& by_a, const Vec3& by_b, Curvature& out) {
    out.dy_dy += weight * by_a * by_a.transpose();
    out.dy_ddy += weight * by_a * by_b.transpose();
    out.ddy_ddy += weight * by_b * by_b.transpose();
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

  static void exact(double scale, const Site& at, Curvature& out) {
    const Vec3 &a = at.dy, &b = at.ddy;
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

/// κ as laid at every site, segment by segment.
std::vector<double> curvatures_as_laid(const Fabric& fabric, int nodes) {
  std::vector<double> found;
  for (int i = 0; i < fabric.segment_count(); ++i)
    for (const GaussNode& node : gauss(nodes)) {
      const Basis b = basis(node.s);
      const Vec3 dy = combine(fabric.points, fabric.first_point(i), b.first);
      const Vec3 ddy = combine(fabric.points, fabric.first_point(i), b.second);
      found.push_back(std::sqrt(squared_curvature(dy, ddy)));
    }
  return found;
}

}  // namespace

std::unique_ptr<Effect> make(const Bend& spec, Parts& parts) {
  BendLaw law;
  if (spec.rest == RestShape::as_laid) law.rest = curvatures_as_laid(parts.fabric, spec.nodes);
  return std::make_unique<AlongYarn<BendLaw>>(std::move(law), parts, spec.nodes, all_segments(parts.fabric));
}

}  // namespace wale
