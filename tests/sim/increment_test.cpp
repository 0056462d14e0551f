#include "sim/solvers/increment.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/make_fabric.hpp"

namespace wale {
namespace {

constexpr double step = 1e-3;  // s

/// Woven yarns that rub, in a step that has moved them a little; all of it, and some control points of it alone.
class Attended : public testing::Test {
 protected:
  Attended() {
    at_.q = fabric_.points;
    shake(at_.q, 0.01e-3, 5);
    for (const auto& increment : {&all_, &some_}) increment->begin(start_, step, start_.q);
    for (int i = 0; i < fabric_.points.cols(); i += i % 7 == 0 ? 1 : 3) points_.push_back(i);
    some_.attend(points_);
  }

  std::unique_ptr<World> world() const {
    return std::make_unique<World>(fabric_, std::vector<EffectSpec>{Stretch{}, Bend{}, Contact{}, Friction{}},
                                   Schedule::ramp(0, 1, 1), start_, std::vector<Clamp>{}, true);
  }

  Stiffness second(Increment& increment) {
    Stiffness exact(increment.points());
    Leeway leeway(fabric_);
    leeway.update(at_.q, increment.world().gaps());
    increment.prepare(at_);
    increment.second(at_, leeway, {Eigen::VectorXd::Ones(fabric_.points.cols())}, Increment::Model::exact, exact);
    return exact;
  }

  const Fabric fabric_ = woven_yarns(6, 24, 2);
  const State start_ = at_rest(fabric_);
  State at_ = start_;
  const std::unique_ptr<World> whole_ = world(), part_ = world();
  Increment all_{*whole_}, some_{*part_};
  std::vector<int> points_;
};

TEST_F(Attended, BearsWhatItBearsAmongAll) {
  Points of_all, of_some;
  all_.value(at_, &of_all);
  some_.value(at_, &of_some);
  ASSERT_EQ(of_some.cols(), static_cast<Eigen::Index>(points_.size()));
  EXPECT_LT((of_some - of_all(Eigen::all, points_)).norm(), 1e-9 * of_all.norm());
}

TEST_F(Attended, IsAsStiffAsAmongAll) {
  Points of_all;
  all_.value(at_, &of_all);
  some_.value(at_, &of_all);
  const Stiffness whole = second(all_), part = second(some_);
  const Points move = Points::Random(3, some_.points());
  Eigen::VectorXd by_whole, by_part;
  whole.multiply(some_.spread(move).reshaped(), by_whole);
  part.multiply(move.reshaped(), by_part);
  const Points expected = by_whole.reshaped(3, fabric_.points.cols())(Eigen::all, points_);
  EXPECT_LT((by_part - expected.reshaped()).norm(), 1e-9 * expected.norm());
}

TEST_F(Attended, LeavesAllElseWhereItIs) {
  const Points move = some_.spread(Points::Ones(3, some_.points()));
  EXPECT_EQ(move.sum(), 3 * some_.points());
  EXPECT_EQ(Points(move(Eigen::all, points_)).minCoeff(), 1);
}

TEST_F(Attended, IsAllAgainWhenItIsNothing) {
  some_.attend({});
  Points of_all, again;
  const double energy = all_.value(at_, &of_all);
  EXPECT_NEAR(some_.value(at_, &again), energy, 1e-12 * std::abs(energy));
  EXPECT_LT((again - of_all).norm(), 1e-9 * of_all.norm());
}

/// One yarn is lifted onto the others while these are held: what it meets there is found.
TEST_F(Attended, FindsWhatItMoves) {
  std::vector<int> yarn;
  for (int k = 0; k < fabric_.yarns[0].points(); ++k) yarn.push_back(fabric_.yarns[0].first_point + k);
  some_.attend(yarn);
  at_ = start_;
  at_.q.middleCols(yarn.front(), static_cast<Eigen::Index>(yarn.size())).row(1).array() += 0.9e-3;
  Points of_all, of_some;
  all_.value(at_, &of_all);
  some_.value(start_, &of_some);
  some_.value(at_, &of_some);
  EXPECT_LT((of_some - of_all(Eigen::all, yarn)).norm(), 1e-9 * of_all.norm());
  some_.attend({});
  some_.value(at_, &of_some);
  EXPECT_LT((of_some - of_all).norm(), 1e-9 * of_all.norm());
}

}  // namespace
}  // namespace wale
