#include "sim/polyline.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/sim/results/made_jersey.hpp"

namespace wale {
namespace {

/// Control points in a straight, even row make the spline x = first + 1 + s.
TEST(Polyline, RunsEvenlyThroughAllItsSegmentsToTheEndOfTheLast) {
  Fabric fabric;
  fabric.yarns = {{0, 0, 4}};
  fabric.segments.resize(4);
  fabric.points = Points::Zero(3, 7);
  for (int i = 0; i < 7; ++i) fabric.points(0, i) = i;
  const Points line = polyline(fabric, fabric.points, 1, 2, 5);
  ASSERT_EQ(line.cols(), 11);
  for (int i = 0; i < 11; ++i) EXPECT_NEAR(line(0, i), 2 + 0.2 * i, 1e-14);
}

TEST(Polyline, RefusesWhatIsNoRangeOfOneYarn) {
  const testing::MadeJersey made = testing::made_jersey(1, 2);
  const Points& q = made.fabric.points;
  EXPECT_THROW(polyline(made.fabric, q, 15, 16, 4), std::invalid_argument);
  EXPECT_THROW(polyline(made.fabric, q, 5, 4, 4), std::invalid_argument);
  EXPECT_THROW(polyline(made.fabric, q, 30, 32, 4), std::invalid_argument);
  EXPECT_THROW(polyline(made.fabric, q, -1, 2, 4), std::invalid_argument);
  EXPECT_THROW(polyline(made.fabric, q, 0, 1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace wale
