#include "tests/stability/passing_through.hpp"

#include <gtest/gtest.h>

#include "sim/tile.hpp"
#include "tests/stability/laid_yarns.hpp"
#include "tests/stability/linking.hpp"
#include "tests/support/cells.hpp"

namespace wale::stability {
namespace {

TEST(KnotDeterminant, TellsAnOverhandKnotFromAYarnThatIsNone) {
  const HardScene knot = hard_case("overhand knot tightened").make(5);
  EXPECT_EQ(knot_determinant(knot.scene.fabric, knot.scene.fabric.points), 3);
  Fabric pressed = knot.scene.fabric;
  pressed.points.row(2) *= -1;
  EXPECT_EQ(knot_determinant(pressed, pressed.points), 3) << "its mirror image";
  Points lifted = knot.scene.fabric.points;
  for (Eigen::Index k = 0; k < lifted.cols(); ++k) lifted(2, k) = 1e-4 * static_cast<double>(k);
  EXPECT_EQ(knot_determinant(knot.scene.fabric, lifted), 1) << "it only rises, so it opens";
}

/// A course that is pulled bodily through the one above leaves it unlinked otherwise than it was.
TEST(CoursesBentRound, AreLinkedOtherwiseOnceOnePassedThroughAnother) {
  const Fabric cell = compile_repeat({"k", "k"}, 12).fabric;
  Points q = points_and_periods(cell);
  const auto before = bent_round(cell, q, 2);
  EXPECT_NEAR(linking_number(before[0], before[1]), std::round(linking_number(before[0], before[1])), 1e-9);
  const Yarn& upper = cell.yarns[1];
  const double highest = q.row(2).head(q.cols() - 2).maxCoeff();
  // One segment of the upper course is drawn from behind the lower one to before it, or back.
  long changes = 0;
  for (int k = 3; k < upper.points() - 3; ++k) {
    Points moved = q;
    moved(2, upper.first_point + k) = moved(2, upper.first_point + k) > 0 ? -4 * highest : 4 * highest;
    const auto after = bent_round(cell, moved, 2);
    changes += std::lround(linking_number(after[0], after[1])) != std::lround(linking_number(before[0], before[1]));
  }
  EXPECT_GT(changes, 0);
}

}  // namespace
}  // namespace wale::stability
