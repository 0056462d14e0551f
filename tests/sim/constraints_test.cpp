#include "sim/constraints.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "sim/spline.hpp"
#include "tests/support/make_fabric.hpp"

namespace wale {
namespace {

Fabric fabric() { return crossing_yarns(ContactLaw::barrier, 3); }

Vec3 end_point(const Fabric& of, const Points& q, const Clamp& clamp) {
  const Yarn& yarn = of.yarns[static_cast<std::size_t>(clamp.yarn)];
  return clamp.at_end ? combine(q, yarn.first_point + yarn.segments - 1, basis(1).value)
                      : combine(q, yarn.first_point, basis(0).value);
}

Vec3 end_tangent(const Fabric& of, const Points& q, const Clamp& clamp) {
  const Yarn& yarn = of.yarns[static_cast<std::size_t>(clamp.yarn)];
  return clamp.at_end ? combine(q, yarn.first_point + yarn.segments - 1, basis(1).first)
                      : combine(q, yarn.first_point, basis(0).first);
}

/// A random change of the control points that the constraints allow.
Points allowed_change(const Constraints& constraints, Eigen::Index points, unsigned seed) {
  Points change = Points::Zero(3, points);
  shake(change, 1e-4, seed);
  Eigen::VectorXd x = change.reshaped();
  constraints.project(x, [](Eigen::VectorXd&) {});
  return x.reshaped(3, points);
}

TEST(Constraints, HoldAnEndWhereItIs) {
  const Fabric of = fabric();
  for (const Clamp clamp : {Clamp{.yarn = 0}, Clamp{.yarn = 1, .at_end = true}}) {
    const Constraints constraints(of, {clamp}, of.points);
    EXPECT_EQ(constraints.rows().rows(), 3);
    const Points change = allowed_change(constraints, of.points.cols(), 5);
    EXPECT_GT(change.norm(), 1e-4);
    EXPECT_LT((end_point(of, of.points + change, clamp) - end_point(of, of.points, clamp)).norm(), 1e-18);
  }
}

TEST(Constraints, HoldTheDirectionOfAnEndAndLeaveItsLengthFree) {
  const Fabric of = fabric();
  for (const Clamp clamp : {Clamp{.yarn = 1, .position = false, .direction = true},
                            Clamp{.yarn = 0, .at_end = true, .position = false, .direction = true}}) {
    const Constraints constraints(of, {clamp}, of.points);
    EXPECT_EQ(constraints.rows().rows(), 2);
    const Vec3 before = end_tangent(of, of.points, clamp);
    const Vec3 after = end_tangent(of, of.points + allowed_change(constraints, of.points.cols(), 6), clamp);
    EXPECT_LT(before.normalized().cross(after).norm(), 1e-17);
    EXPECT_GT(std::abs(before.norm() - after.norm()), 1e-6);
  }
}

TEST(Constraints, ProjectASolutionAsTheFullSaddlePointSystemWould) {
  const Fabric of = fabric();
  const Constraints constraints(of, {{.yarn = 0, .direction = true}, {.yarn = 1, .at_end = true}}, of.points);
  const Eigen::MatrixXd& c = constraints.rows();
  const Eigen::Index n = c.cols(), m = c.rows();
  std::srand(4);
  const Eigen::MatrixXd root = Eigen::MatrixXd::Random(n, n);
  const Eigen::MatrixXd a = root * root.transpose() + Eigen::MatrixXd::Identity(n, n);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(n);

  Eigen::MatrixXd saddle = Eigen::MatrixXd::Zero(n + m, n + m);
  saddle << a, c.transpose(), c, Eigen::MatrixXd::Zero(m, m);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + m);
  right.head(n) = b;
  const Eigen::VectorXd expected = saddle.fullPivLu().solve(right).head(n);

  const Eigen::LLT<Eigen::MatrixXd> factor(a);
  Eigen::VectorXd x = factor.solve(b);
  constraints.project(x, [&](Eigen::VectorXd& y) { y = factor.solve(y).eval(); });
  EXPECT_LT((x - expected).norm(), 1e-9 * expected.norm());
}

TEST(Constraints, DoNoHarmWhenAClampIsNamedTwice) {
  const Fabric of = fabric();
  const Clamp clamp{.yarn = 0, .direction = true};
  const Points once = allowed_change(Constraints(of, {clamp}, of.points), of.points.cols(), 8);
  const Points twice = allowed_change(Constraints(of, {clamp, clamp}, of.points), of.points.cols(), 8);
  EXPECT_LT((once - twice).norm(), 1e-12 * once.norm());
}

TEST(Constraints, ChangeNothingWhenThereAreNone) {
  const Fabric of = fabric();
  const Constraints none(of, {}, of.points);
  EXPECT_TRUE(none.empty());
  Eigen::VectorXd x = Eigen::VectorXd::Ones(of.points.size());
  none.project(x, [](Eigen::VectorXd& y) { y.setZero(); });
  EXPECT_EQ(x, Eigen::VectorXd::Ones(of.points.size()));
}

}  // namespace
}  // namespace wale
