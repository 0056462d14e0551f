#include "sim/world.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"
#include "tests/support/resting_jersey.hpp"

namespace wale {
namespace {

const RestingJersey& jersey() {
  static const RestingJersey made(4);
  return made;
}

/// Half the points, in runs of no particular length.
std::vector<std::uint8_t> some_held() {
  std::vector<std::uint8_t> held(static_cast<std::size_t>(jersey().fabric().points.cols()));
  for (std::size_t i = 0; i < held.size(); ++i) held[i] = i % 97 < 50 || i % 31 < 3;
  return held;
}

TEST(World, DoesToPointsThatMoveTheSameThoughOthersAreHeld) {
  const OneThread one;
  const std::vector<EffectSpec> others{Friction{.threshold = 1e-2}, ContactDamping{20, 10}, Drag{}, Gravity{},
                                       jersey().hook(1e-3, 1.0)};
  State state = jersey().state();
  shake(state.q, 1e-5, 1);
  shake(state.v, 1e-1, 2);
  const std::vector<std::uint8_t> held = some_held();
  for (int i = 0; i < state.q.cols(); ++i)
    if (held[static_cast<std::size_t>(i)]) state.v.col(i).setZero();
  const auto world = jersey().world(others), partly = jersey().world(others);
  partly->hold(held);
  Points acceleration, force, force_partly, acceleration_partly;
  world->accelerate(state, acceleration, &force);
  partly->accelerate(state, acceleration_partly, &force_partly);
  const double largest = force.colwise().norm().maxCoeff();
  for (int i = 0; i < state.q.cols(); ++i) {
    if (held[static_cast<std::size_t>(i)])
      EXPECT_EQ(acceleration_partly.col(i), Vec3(Vec3::Zero())) << i;
    else
      EXPECT_LT((force.col(i) - force_partly.col(i)).norm(), 1e-13 * largest) << i;
  }
  // M a = f where points move, with those held in their places.
  const Points borne = partly->mass().times(acceleration_partly);
  for (int i = 0; i < state.q.cols(); ++i)
    if (!held[static_cast<std::size_t>(i)]) {
      EXPECT_LT((borne.col(i) - force.col(i)).norm(), 1e-12 * largest) << i;
    }
}

TEST(World, DoesNotAskWhatSegmentsThatAreHeldBear) {
  const OneThread one;
  const Fabric& fabric = jersey().fabric();
  World world(fabric, {Stretch{}, Bend{}, Gravity{}, Plates{.gap = 0}}, 0.0, jersey().state());
  const std::vector<std::uint8_t> held(static_cast<std::size_t>(fabric.points.cols()), 1);
  std::vector<std::uint8_t> all_but_one = held;
  all_but_one[20] = 0;
  world.hold(all_but_one);
  Points acceleration, force;
  world.accelerate(jersey().state(), acceleration, &force);
  // Three control points either way share a segment with it.
  for (int i = 0; i < force.cols(); ++i) EXPECT_EQ(force.col(i).isZero(0), i < 17 || i > 23) << i;
}

TEST(World, DoesNotLookAtPairsOfWhichBothSidesAreHeld) {
  const OneThread one;
  const auto world = jersey().world({});
  world->prepare(jersey().state());
  const std::vector<Gap> all = world->gaps();
  const std::vector<std::uint8_t> held = some_held();
  const auto sleeps = [&](int segment) {
    const auto first = held.begin() + jersey().fabric().first_point(segment);
    return std::count(first, first + 4, 1) == 4;
  };
  world->hold(held);
  world->prepare(jersey().state());
  const auto looked_at = world->gaps().size();
  EXPECT_EQ(static_cast<long>(looked_at),
            std::count_if(all.begin(), all.end(), [&](const Gap& gap) { return !sleeps(gap.a) || !sleeps(gap.b); }));
  EXPECT_LT(looked_at, all.size());
  world->forget();
  world->prepare(jersey().state());
  EXPECT_EQ(world->gaps().size(), looked_at);
  world->hold({});
  world->prepare(jersey().state());
  EXPECT_EQ(world->gaps().size(), all.size());
}

}  // namespace
}  // namespace wale
