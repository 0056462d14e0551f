#include "bench/peers/set_yarn.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "bench/peers/patch.hpp"
#include "sim/world.hpp"
#include "tests/support/finite_difference.hpp"
#include "tests/support/make_fabric.hpp"

namespace wale::peers {
namespace {

/// A loop of the patch that is laid at an uneven speed, as coarse as it may be.
class SetYarnOf : public testing::Test {
 protected:
  double energy(const Points& q, Points* force = nullptr, Stiffness* exact = nullptr, Stiffness* convex = nullptr) {
    State at = at_rest(fabric_);
    at.q = q;
    double found = 0;
    Load load{.energy = &found, .force = force, .stiffness = exact, .convex = convex};
    yarn_->add(at, load);
    return found;
  }
  Points force(const Points& q) {
    Points found = Points::Zero(3, q.cols());
    energy(q, &found);
    return found;
  }

  const Fabric fabric_ = lay({.wales = 1, .courses = 1, .segments_per_stitch = 8, .shrinkage = 0.9});
  const State start_ = at_rest(fabric_);
  const RestSchedules as_laid_ = 0.0, as_knitted_ = 1.0;
  const Parts laid_{fabric_, as_laid_, start_}, tightened_{fabric_, as_knitted_, start_};
  std::unique_ptr<Effect> yarn_ = set_yarn(laid_);
  const double scale_ = fabric_.materials[0].axial_stiffness;  // N
};

TEST_F(SetYarnOf, IsWithoutStressAsItLies) {
  EXPECT_LT(energy(fabric_.points), 1e-20 * scale_);
  EXPECT_LT(force(fabric_.points).norm(), 1e-10 * scale_);
}

TEST_F(SetYarnOf, IsWithoutStressAsItLiesWhenBothHaveShrunk) {
  yarn_ = set_yarn(tightened_);
  const double left = fabric_.segments[0].knitted / fabric_.segments[0].length;
  EXPECT_LT(force(left * fabric_.points).norm(), 1e-10 * scale_);
  EXPECT_GT(force(fabric_.points).norm(), 1e-2 * scale_);
}

TEST_F(SetYarnOf, PushesDownTheSlopeOfItsEnergy) {
  Points q = fabric_.points;
  shake(q, 0.2e-3, 3);
  const auto by_energy = [this](const Points& x) { return Eigen::VectorXd::Constant(1, energy(x)); };
  const Eigen::VectorXd slope = slope_of(by_energy, q, 1e-7).transpose();
  EXPECT_LT((force(q).reshaped() + slope).norm(), 1e-6 * slope.norm());
}

/// What is left out is in proportion to the departure from the rest shape, in the convex part to its slack as well.
TEST_F(SetYarnOf, HasItsSecondSlopeWhereItRests) {
  Stiffness exact(static_cast<int>(fabric_.points.cols())), convex = exact;
  energy(fabric_.points, nullptr, &exact, &convex);
  const auto by_force = [this](const Points& x) { return Eigen::VectorXd(-force(x).reshaped()); };
  const Eigen::MatrixXd slope = slope_of(by_force, fabric_.points, 1e-7);
  EXPECT_LT((dense(exact) - slope).norm(), 1e-6 * slope.norm());
  EXPECT_LT((dense(convex) - slope).norm(), 1e-6 * slope.norm());
}

TEST_F(SetYarnOf, HasTheSecondSlopeOfItsStretch) {
  Points q = 1.1 * fabric_.points;  // in which bend has hardly a share
  Stiffness exact(static_cast<int>(q.cols())), convex = exact;
  energy(q, nullptr, &exact, &convex);
  const auto by_force = [this](const Points& x) { return Eigen::VectorXd(-force(x).reshaped()); };
  const Eigen::MatrixXd slope = slope_of(by_force, q, 1e-7);
  EXPECT_LT((dense(exact) - slope).norm(), 1e-2 * slope.norm());
  q = 0.9 * fabric_.points;
  energy(q, nullptr, nullptr, &convex);
  EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense(convex)).eigenvalues().minCoeff(),
            -1e-9 * dense(convex).norm());
}

}  // namespace
}  // namespace wale::peers
