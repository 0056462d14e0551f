#include "sim/solvers/leeway.hpp"

#include <gtest/gtest.h>

#include "sim/stiffness.hpp"
#include "tests/support/make_fabric.hpp"

namespace wale {
namespace {

/// As many straight yarns side by side as each has segments.
Fabric sheet(int yarns) {
  Fabric fabric;
  fabric.materials = {Material{}};
  const double apart = 0.9 * fabric.materials[0].diameter;
  for (int row = 0; row < yarns; ++row)
    add_yarn(fabric, straight_points({0, row * apart, 0}, {yarns * apart, row * apart, 0}, yarns), apart);
  return fabric;
}

std::vector<Gap> side_by_side(const Fabric& fabric) {
  std::vector<Gap> gaps;
  const double diameter = fabric.materials[0].diameter;
  const int in_each = fabric.yarns[0].segments;
  for (int a = 0; a + in_each < fabric.segment_count(); ++a)
    gaps.push_back({.a = a, .b = a + in_each, .distance = 0.9 * diameter, .diameter = diameter});
  return gaps;
}

/// What the shift of weight 1 costs a motion, a control point, m².
double cost(const Fabric& fabric, const std::vector<Gap>& gaps, const Points& move) {
  Leeway leeway(fabric);
  leeway.update(fabric.points, gaps);
  Stiffness K(static_cast<int>(fabric.points.cols()));
  leeway.add_to(K, Eigen::VectorXd::Ones(fabric.points.cols()));
  Eigen::VectorXd force;
  K.multiply(move.reshaped(), force);
  return move.reshaped().dot(force) / 2 / static_cast<double>(fabric.points.cols());
}

double cost_of_strain(int yarns) {
  const Fabric fabric = sheet(yarns);
  const Points strain = 0.01 * (fabric.points.colwise() - fabric.points.rowwise().mean());
  return cost(fabric, side_by_side(fabric), strain);
}

TEST(Leeway, HoldsALargeFabricBackFromAStrainNoMoreThanASmallOne) {
  EXPECT_NEAR(cost_of_strain(120) / cost_of_strain(40), 1, 0.1);
}

TEST(Leeway, HoldsLooseYarnWhereItIs) {
  const Fabric fabric = sheet(80);
  const Points aside = Vec3(0, 0, 1e-3).replicate(1, fabric.points.cols());
  EXPECT_NEAR(cost(fabric, {}, aside), 0.01 * 1e-6 / 2, 1e-12);
  EXPECT_LT(cost(fabric, side_by_side(fabric), aside), 0.7 * 0.01 * 1e-6 / 2);
}

}  // namespace
}  // namespace wale
