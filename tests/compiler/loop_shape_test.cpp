#include "compiler/passes/loop_shape.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace wale {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double d = 0.5e-3;

/// Three loops side by side, with the loop pulled through each: all 64 cases.
struct Row {
  LoopSigns left, here, right;
};

std::vector<Row> all_rows() {
  std::vector<Row> rows;
  const auto sign = [](int bits, int bit) { return bits >> bit & 1 ? 1 : -1; };
  for (int b = 0; b < 64; ++b)
    rows.push_back({{sign(b, 0), sign(b, 1)}, {sign(b, 2), sign(b, 3)}, {sign(b, 4), sign(b, 5)}});
  return rows;
}

Vec3 point(const Row& row, double w) { return loop_point(loose_loops(d, 1), row.left, row.here, row.right, w).y; }

/// The parameters, on the right side, at which a loop crosses those above and below: head, upper leg, lower leg,
/// sinker. Both legs' crossings follow from the loop's drawing alone: x(w) = x(v), y(w) = y(v) + pitch.
std::array<double, 4> crossings() {
  const LoopSize size = loose_loops(d, 1);
  const auto x = [](double w) { return w + std::sin(pi * w); };
  const auto v_of = [&](double w) { return 2 / pi * std::acos(std::cos(pi * w / 2) - size.pitch / size.y); };
  std::array<double, 4> found{};
  const auto solve = [&](double low, double high) {
    const auto gap = [&](double w) { return x(w) - x(v_of(w)); };
    const bool rising = gap(high) > gap(low);
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      ((gap(middle) > 0) == rising ? high : low) = middle;
    }
    return low;
  };
  // w on the parent, whose upper half lies one pitch above the child's lower half.
  const double most = 2 / pi * std::acos(size.pitch / size.y - 1);
  found[0] = solve(0, most / 2);
  found[1] = solve(most / 2, most);
  found[2] = v_of(found[0]);
  found[3] = v_of(found[1]);
  return found;
}

TEST(LoopShape, CrossesItsNeighboursOnceInEachQuarter) {
  const auto w = crossings();
  EXPECT_GT(w[0], 0.05);
  EXPECT_LT(w[0], w[1]);
  EXPECT_LT(w[1], 1);
  EXPECT_GT(w[2], 1);
  EXPECT_LT(w[2], w[3]);
  EXPECT_LT(w[3], 1.95);
}

TEST(LoopShape, OfJerseyHasThePapersDepth) {
  const double z = loose_loops(d, 1).z;
  for (const int s : {-1, 1})
    for (double w = -2; w <= 2; w += 0.01)
      EXPECT_NEAR(point({{s, s}, {s, s}, {s, s}}, w).z(), -s * z * std::cos(pi * w), 1e-15) << w;
}

TEST(LoopShape, HasThePapersOutline) {
  const LoopSize size = loose_loops(d, 1);
  for (const Row& row : all_rows())
    for (double w = -2; w <= 2; w += 0.1) {
      EXPECT_NEAR(point(row, w).x(), size.x * (w + std::sin(pi * w)), 1e-15);
      EXPECT_NEAR(point(row, w).y(), size.y * std::cos(pi * w / 2), 1e-15);
    }
}

TEST(LoopShape, LiesAtTheFourDepthsThatTheStitchesDemand) {
  const auto w = crossings();
  for (const Row& row : all_rows())
    for (const int side : {-1, 1}) {
      const int s = row.here.own, above = row.here.above;
      EXPECT_LT(point(row, side * w[0]).z() * above, 0);
      EXPECT_GT(point(row, side * w[1]).z() * above, 0);
      EXPECT_GT(point(row, side * w[2]).z() * s, 0);
      EXPECT_LT(point(row, side * w[3]).z() * s, 0);
    }
}

TEST(LoopShape, DerivativeIsTheSlope) {
  constexpr double h = 1e-3;
  for (const Row& row : all_rows())
    for (double w = -1.99; w < 2; w += 0.0713) {
      const Vec3 slope =
          (8 * (point(row, w + h) - point(row, w - h)) - (point(row, w + 2 * h) - point(row, w - 2 * h))) / (12 * h);
      const Vec3 given = loop_point(loose_loops(d, 1), row.left, row.here, row.right, w).dy;
      EXPECT_NEAR((given - slope).norm(), 0, 1e-6 * d) << w;
    }
}

TEST(LoopShape, GoesOnIntoTheNextLoopWithTwoDerivatives) {
  constexpr double h = 1e-4;
  const Vec3 wale(loose_loops(d, 1).wale(), 0, 0);
  for (const Row& row : all_rows()) {
    const Row next{row.here, row.right, {1, -1}};
    const auto a = [&](double w) { return point(row, w); };
    const auto b = [&](double w) { return Vec3(point(next, w - 4) + wale); };
    EXPECT_NEAR((a(2) - b(2)).norm(), 0, 1e-12 * d);
    const Vec3 slope_a = (3 * a(2) - 4 * a(2 - h) + a(2 - 2 * h)) / (2 * h);
    const Vec3 slope_b = -(3 * b(2) - 4 * b(2 + h) + b(2 + 2 * h)) / (2 * h);
    EXPECT_NEAR((slope_a - slope_b).norm(), 0, 1e-4 * d);
    const auto second = [&](const auto& y, double by) {
      return Vec3((2 * y(2) - 5 * y(2 + by) + 4 * y(2 + 2 * by) - y(2 + 3 * by)) / (by * by));
    };
    EXPECT_NEAR((second(a, -h) - second(b, h)).norm(), 0, 1e-3 * second(a, -h).norm() + 1e-2 * d);
  }
}

}  // namespace
}  // namespace wale
