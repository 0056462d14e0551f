#include "sim/mid_surface.hpp"

#include <gtest/gtest.h>

#include "tests/support/finite_difference.hpp"

namespace wale {
namespace {

const PeriodicCell cell{.course = {3e-3, 0, 0}, .wale = {0, 2e-3, 0}, .curls = Curls::about_courses};
const Eigen::VectorXd weights{{1, 2, 3, 1, 9, 9}};
const std::array<double, 4> curvatures{0, 1e-4, 300, -200};  // 1/m

/// Four points of which the height over the mid-surface is known, and two periods.
Points with(double curvature, double height) {
  Points q(3, 6);
  q << 0, 1, 2, 3, 3, 0, /**/ -1, 0.3, 0.5, 1.5, 0, 2, /**/ 0.3, -0.6, 0.1, 0.6, 0, 0;
  q *= 1e-3;
  q.row(2).head(4).array() += height;
  for (int k = 0; k < 4; ++k) q.col(k) = rolled_up(q.col(k), {curvature, 1});
  q(2, 5) = curvature * curl_unit(cell);
  return q;
}

TEST(MidSurface, IsTheMeanHeightRolledOut) {
  for (const double curvature : curvatures)
    EXPECT_NEAR(MidSurface(cell, weights).height(with(curvature, 0.2e-3)), 0.2e-3, 1e-17) << curvature;
}

TEST(MidSurface, HasTheSlopesOfItsHeight) {
  const MidSurface surface(cell, weights);
  for (const double curvature : curvatures) {
    const Points q = with(curvature, 0.2e-3);
    const Eigen::MatrixXd by =
        slope_of([&](const Points& x) { return Eigen::VectorXd::Constant(1, surface.height(x)); }, q, 1e-7);
    EXPECT_LT((surface.slope(q).reshaped() - by.transpose()).cwiseAbs().maxCoeff(), 1e-8) << curvature;
  }
}

TEST(MidSurface, IsSettledAlongItsNormals) {
  const MidSurface surface(cell, weights);
  for (const double curvature : curvatures) {
    Points q = with(curvature, 0.2e-3);
    surface.settle(q);
    EXPECT_LT((q - with(curvature, 0)).norm(), 1e-16) << curvature;
  }
}

}  // namespace
}  // namespace wale
