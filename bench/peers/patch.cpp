#include "bench/peers/patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "compiler/passes.hpp"
#include "compiler/passes/arc_length.hpp"
#include "sim/polyline.hpp"

namespace wale::peers {
namespace {

using std::numbers::pi;

constexpr double lambda_x = 1.25e-3, lambda_y = 2.7e-3, lambda_z = 0.8e-3, course_spacing = 3.6e-3;  // m
constexpr double radius = 0.524e-3;                                                                  // m

/// Eq. (4): w runs over [-2, 2] in a stitch, with its head at 0.
CurvePiece::Point loop(int wale, int course, double w) {
  const Vec3 middle(4 * lambda_x * wale, course_spacing * course, 0);
  return {
      middle + Vec3(lambda_x * (w + std::sin(pi * w)), lambda_y * std::cos(pi * w / 2), lambda_z * std::cos(pi * w)),
      Vec3(lambda_x * (1 + pi * std::cos(pi * w)), -lambda_y * pi / 2 * std::sin(pi * w / 2),
           -lambda_z * pi * std::sin(pi * w))};
}

YarnCurve row(const Patch& patch, int course) {
  YarnCurve yarn;
  for (int wale = 0; wale < patch.wales; ++wale) {
    const auto at = [wale, course](double u) {
      CurvePiece::Point point = loop(wale, course, 4 * u - 2);
      point.dy *= 4;
      return point;
    };
    yarn.pieces.push_back({.at = at, .stitch = course * patch.wales + wale});
  }
  const ArcLength arc(yarn);
  for (std::size_t i = 0; i < yarn.pieces.size(); ++i)
    yarn.pieces[i].stitch_length = patch.shrinkage * arc.length_of(i);
  return yarn;
}

Points axis_of(const Fabric& fabric, const Points& q, const Yarn& yarn) {
  constexpr int per_segment = 16;
  return polyline(fabric, q, yarn.first_segment, yarn.first_segment + yarn.segments - 1, per_segment);
}

constexpr int per_stitch = 8000;  // points of a curve by which distances from it are measured

Points shrunk_loops(const Patch& patch, int course) {
  Points curve(3, per_stitch * patch.wales + 1);
  for (int i = 0; i < curve.cols(); ++i) {
    const int wale = std::min(i / per_stitch, patch.wales - 1);
    curve.col(i) = patch.shrinkage * loop(wale, course, 4.0 * (i - wale * per_stitch) / per_stitch - 2).y;
  }
  return curve;
}

/// Of the box around a curve.
Vec3 middle(const Points& curve) { return (curve.rowwise().maxCoeff() + curve.rowwise().minCoeff()) / 2; }

/// From a curve, a quarter of a stitch to both sides of its point `nearby`.
double distance(const Vec3& from, const Points& curve, Eigen::Index nearby) {
  double least = std::numeric_limits<double>::infinity();
  const Eigen::Index last = std::min<Eigen::Index>(nearby + per_stitch / 4, curve.cols() - 1);
  for (Eigen::Index i = std::max<Eigen::Index>(nearby - per_stitch / 4, 0); i < last; ++i) {
    const Vec3 along = curve.col(i + 1) - curve.col(i), off = from - curve.col(i);
    const double share = std::clamp(off.dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (off - share * along).norm());
  }
  return least;
}

}  // namespace

Material patch_yarn() {
  Material yarn;
  yarn.name = "peers";
  yarn.linear_density = 77e-6;
  yarn.axial_stiffness = 79e6 * pi * radius * radius;
  yarn.bending_rigidity = 0.249e6 * pi * std::pow(radius, 4) / 4;
  yarn.diameter = 2 * radius;
  yarn.contact_stiffness = 1e3;
  return yarn;
}

Fabric lay(const Patch& patch) {
  Curves curves;
  for (int course = 0; course < patch.courses; ++course) curves.yarns.push_back(row(patch, course));
  return passes::fit(curves, {patch_yarn()}, patch.segments_per_stitch);
}

Vec3 extent(const Fabric& fabric, const Points& q) {
  Vec3 low = Vec3::Constant(1e9), high = -low;
  for (const Yarn& yarn : fabric.yarns) {
    const Points axis = axis_of(fabric, q, yarn);
    low = low.cwiseMin(axis.rowwise().minCoeff());
    high = high.cwiseMax(axis.rowwise().maxCoeff());
  }
  return high - low;
}

double off_shape(const Patch& patch, const Fabric& fabric, const Points& q) {
  double most = 0;
  for (std::size_t course = 0; course < fabric.yarns.size(); ++course) {
    const Points expected = shrunk_loops(patch, static_cast<int>(course));
    const Points axis = axis_of(fabric, q, fabric.yarns[course]);
    const Vec3 moved = middle(axis) - middle(expected);
    for (Eigen::Index i = 0; i < axis.cols(); ++i) {
      const auto nearby = i * expected.cols() / axis.cols();
      most = std::max(most, distance(axis.col(i) - moved, expected, nearby));
    }
  }
  return most;
}

}  // namespace wale::peers
