#include "bench/peers/patch.hpp"

#include <cmath>
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
  constexpr int per_segment = 16;
  Vec3 low = Vec3::Constant(1e9), high = -low;
  for (const Yarn& yarn : fabric.yarns) {
    const Points axis = polyline(fabric, q, yarn.first_segment, yarn.first_segment + yarn.segments - 1, per_segment);
    low = low.cwiseMin(axis.rowwise().minCoeff());
    high = high.cwiseMax(axis.rowwise().maxCoeff());
  }
  return high - low;
}

}  // namespace wale::peers
