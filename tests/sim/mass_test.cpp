#include "sim/mass.hpp"

#include <gtest/gtest.h>

#include "tests/support/make_fabric.hpp"

namespace wale {
namespace {

/// The full matrix from the lower band.
Eigen::MatrixXd full(const Eigen::MatrixXd& band) {
  const Eigen::Index n = band.cols();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index k = 0; k < band.rows() && j + k < n; ++k) matrix(j + k, j) = matrix(j, j + k) = band(k, j);
  return matrix;
}

/// Ding et al. 2023, Table A.2; the printed rows j = -1, 0, 1 are indices 0, 1, 2 here.
TEST(Mass, HasTheEntriesOfTableA2) {
  const Eigen::MatrixXd m = full(mass_band(std::vector<double>(8, 1.0)));
  ASSERT_EQ(m.rows(), 11);
  EXPECT_NEAR(m(0, 0), 1.0 / 252, 1e-15);
  EXPECT_NEAR(m(0, 1), 43.0 / 1680, 1e-15);
  EXPECT_NEAR(m(0, 2), 1.0 / 84, 1e-15);
  EXPECT_NEAR(m(0, 3), 1.0 / 5040, 1e-15);
  EXPECT_NEAR(m(1, 1), 151.0 / 630, 1e-15);
  EXPECT_NEAR(m(1, 2), 59.0 / 280, 1e-15);
  EXPECT_NEAR(m(2, 2), 599.0 / 1260, 1e-15);
  EXPECT_NEAR(m(5, 5), 151.0 / 315, 1e-15);
  EXPECT_NEAR(m(5, 6), 397.0 / 1680, 1e-15);
  EXPECT_NEAR(m(5, 7), 1.0 / 42, 1e-15);
  EXPECT_NEAR(m(5, 8), 1.0 / 5040, 1e-15);
  EXPECT_EQ(m(0, 4), 0);
}

TEST(Mass, IsTheSameFromEitherEndAndSumsToTheNumberOfSegments) {
  for (const int n : {1, 2, 3, 20}) {
    const Eigen::MatrixXd m = full(mass_band(std::vector<double>(static_cast<std::size_t>(n), 1.0)));
    EXPECT_LT((m - m.reverse()).cwiseAbs().maxCoeff(), 1e-16);
    EXPECT_NEAR(m.sum(), n, 1e-13);
  }
}

/// Validation.md E02: where the printed table does not reach.
TEST(Mass, IsRightForYarnsTooShortForTheTable) {
  EXPECT_NEAR(full(mass_band({1, 1}))(2, 2), 33.0 / 70, 1e-15);
  EXPECT_NEAR(full(mass_band({1}))(1, 1), 33.0 / 140, 1e-15);
}

Fabric uneven_fabric() {
  Fabric fabric = crossing_yarns(ContactLaw::barrier, 1);
  fabric.materials[1].linear_density = 30e-6;
  for (std::size_t i = 0; i < fabric.segments.size(); ++i)
    fabric.segments[i].length *= 1 + 0.1 * static_cast<double>(i);
  return fabric;
}

TEST(Mass, WeighsEachSegmentByItsOwnMaterialAndLengthAsLaid) {
  Fabric fabric = uneven_fabric();
  for (Segment& segment : fabric.segments) segment.knitted = 0.5 * segment.length;
  double mass = 0;
  for (int i = 0; i < fabric.segment_count(); ++i)
    mass += fabric.material_of(i).linear_density * fabric.segment(i).length;
  const Points drift = Vec3(2, 0, 0).replicate(1, fabric.points.cols());
  EXPECT_NEAR(Mass(fabric).times(drift).row(0).sum(), 2 * mass, 1e-14 * mass);
  EXPECT_NEAR(Mass(fabric).kinetic_energy(drift), 2 * mass, 1e-14 * mass);
}

TEST(Mass, SolvesWhatItMultiplies) {
  const Fabric fabric = uneven_fabric();
  const Mass mass(fabric);
  const State state = shaken_state(fabric, 1, 7);
  Points b = mass.times(state.v);
  EXPECT_GT(b.norm(), 0);
  mass.solve(b);
  EXPECT_LT((b - state.v).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Mass, RefusesAYarnWithoutMass) {
  Fabric fabric = straight_rod(0.01, 4);
  fabric.materials[0].linear_density = 0;
  EXPECT_THROW(Mass{fabric}, std::invalid_argument);
}

}  // namespace
}  // namespace wale
