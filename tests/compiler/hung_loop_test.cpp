#include "compiler/passes/hung_loop.hpp"

#include <gtest/gtest.h>

namespace wale {
namespace {

constexpr double d = 0.5e-3;
const LoopSize size = loose_loops(d, 1);

Bearing upright(double x, LoopSigns signs) {
  Bearing bearing;
  bearing.feet.at = {x, -size.pitch / 2, 0};
  bearing.head.at = {x, size.pitch / 2, 0};
  bearing.signs = signs;
  return bearing;
}

HungLoop row(int bits) {
  const auto sign = [bits](int bit) { return bits >> bit & 1 ? 1 : -1; };
  return {upright(0, {sign(0), sign(1)}), upright(-size.wale(), {sign(2), sign(3)}),
          upright(size.wale(), {sign(4), sign(5)})};
}

TEST(HungLoop, IsTheLoopOfARowWhereAnchorsStandAsInOne) {
  for (int bits = 0; bits < 64; ++bits) {
    const HungLoop loop = row(bits);
    for (double w = -2; w <= 2; w += 0.05) {
      const Curve3 hung = hung_point(size, loop, w);
      const Curve3 flat = loop_point(size, loop.left->signs, loop.here.signs, loop.right->signs, w);
      EXPECT_LT((hung.y - flat.y).norm(), 1e-15) << bits << " " << w;
      EXPECT_LT((hung.dy - flat.dy).norm(), 1e-15) << bits << " " << w;
    }
  }
}

/// Leaning, stretched, one of several at its anchors, crossing another: nothing is where it was.
HungLoop carried_off() {
  HungLoop loop = row(5);
  loop.here.feet = {{0.1e-3, -2e-3, 0.3e-3}, Vec3(0.2, 1, 0).normalized(), 1.6, 0.25e-3};
  loop.here.head = {{1.5e-3, 3e-3, -0.5e-3}, Vec3(-0.4, 1, 0).normalized(), 1, -0.5e-3};
  loop.here.aside = 0.6e-3;
  loop.right->feet.at += Vec3(0.2e-3, 0.4e-3, -0.3e-3);
  loop.left->head.at += Vec3(-0.1e-3, 0.7e-3, 0.2e-3);
  return loop;
}

TEST(HungLoop, HasTheSlopeThatItsPointsHave) {
  constexpr double h = 1e-5;
  for (double w = -1.98; w < 2; w += 0.07) {
    const Vec3 difference =
        (hung_point(size, carried_off(), w + h).y - hung_point(size, carried_off(), w - h).y) / (2 * h);
    EXPECT_LT((hung_point(size, carried_off(), w).dy - difference).norm(), 1e-9) << w;
  }
}

TEST(HungLoop, GoesOverIntoItsNeighbourWithoutAKink) {
  const HungLoop left = carried_off();
  HungLoop right;
  right.here = *left.right;
  right.left = left.here;
  const Curve3 end = hung_point(size, left, 2), begin = hung_point(size, right, -2);
  EXPECT_LT((end.y - begin.y).norm(), 1e-12);
  EXPECT_LT((end.dy - begin.dy).norm(), 1e-9);
}

TEST(HungLoop, StandsAsideInTheMiddleOfItsLegsOnly) {
  HungLoop loop{upright(0, {}), {}, {}}, aside = loop;
  aside.here.aside = 1e-3;
  EXPECT_NEAR((hung_point(size, aside, 1).y - hung_point(size, loop, 1).y).z(), 1e-3, 1e-15);
  for (const double w : {-2.0, 0.0, 2.0})
    EXPECT_LT((hung_point(size, aside, w).y - hung_point(size, loop, w).y).norm(), 1e-15);
}

}  // namespace
}  // namespace wale
