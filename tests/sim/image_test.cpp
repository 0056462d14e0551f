#include "sim/image.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace wale {
namespace {

PeriodicCell cell_that_curls(Curls curls) { return {.course = {3e-3, 0, 0}, .wale = {0, 2e-3, 0}, .curls = curls}; }
const PeriodicCell cell = cell_that_curls(Curls::about_courses);
const std::vector<PeriodicCell> both_ways{cell, cell_that_curls(Curls::about_wales)};
const Vec3 place(0.4e-3, 0.7e-3, -0.3e-3), force(0.3, -0.2, 0.5);

Periods periods_with(double curvature, const PeriodicCell& of = cell) {
  Periods periods;
  periods << 3.1e-3, 0.4e-3, 0, 2.2e-3, 0, curvature * curl_unit(of);
  return periods;
}

const std::array<Eigen::Vector2i, 4> steps{{{0, 1}, {1, 1}, {-2, 3}, {1, 0}}};
const std::array<double, 5> curvatures{0, 1e-4, 37, -150, 700};  // 1/m

/// Central difference of `of` by coordinate `axis` of a period.
template <class Of>
auto difference(const Of& of, const Periods& at, int axis, int period) {
  const double step = 1e-7;
  Periods ahead = at, behind = ahead;
  ahead(axis, period) += step;
  behind(axis, period) -= step;
  return ((of(ahead) - of(behind)) / (2 * step)).eval();
}

TEST(Image, IsAShiftWhereTheFabricIsFlat) {
  const Periods periods = periods_with(0);
  for (const Eigen::Vector2i& step : steps) {
    const Image image(cell, periods, step);
    EXPECT_LT((image(place) - (place + periods * step.cast<double>())).norm(), 1e-18);
  }
}

TEST(Image, TurnsAboutAnAxisAtTheRadius) {
  const double curvature = 250;
  const Vec3 axis(0, 0, 1 / curvature);
  const Image image(cell, periods_with(curvature), {0, 1});
  const auto radius = [&](const Vec3& y) { return (y - axis).tail<2>().norm(); };
  EXPECT_NEAR(radius(image(place)), radius(place), 1e-15);
  // What lies in the mid-surface goes on along it, by its arc.
  const Vec3 on = image(Vec3::Zero());
  EXPECT_NEAR(std::atan2(on.y(), axis.z() - on.z()) / curvature, 2.2e-3, 1e-15);
}

TEST(Image, OfAnImageIsAnImage) {
  for (const double curvature : curvatures) {
    const Periods periods = periods_with(curvature);
    const Vec3 twice = Image(cell, periods, {1, 2})(Image(cell, periods, {-2, -1})(place));
    EXPECT_LT((twice - Image(cell, periods, {-1, 1})(place)).norm(), 1e-16);
    const Image image(cell, periods, {1, 2});
    EXPECT_LT((image.back(image(place)) - place).norm(), 1e-17);
  }
}

/// Calls check(cell, periods, steps, period, axis) for all that an image depends on.
template <class Check>
void each_derivative(const Check& check) {
  for (const PeriodicCell& of : both_ways)
    for (const double curvature : curvatures)
      for (const Eigen::Vector2i& step : steps)
        for (int period = 0; period < 2; ++period)
          for (int axis = 0; axis < (period == 1 ? 3 : 2); ++axis) {
            SCOPED_TRACE(std::to_string(around(of)) + " " + std::to_string(curvature));
            check(of, periods_with(curvature, of), step, period, axis);
          }
}

TEST(Image, HasTheDerivativesOfItsPlace) {
  each_derivative([](const PeriodicCell& of, const Periods& at, const Eigen::Vector2i& step, int period, int axis) {
    const auto placed = [&](const Periods& there) { return Image(of, there, step)(place); };
    const Vec3 by = difference(placed, at, axis, period);
    EXPECT_LT((Image(of, at, step).by_period(place, period).col(axis) - by).norm(), 2e-7);
  });
}

TEST(Image, HasTheSecondDerivativesOfItsPlace) {
  each_derivative([](const PeriodicCell& of, const Periods& at, const Eigen::Vector2i& step, int period, int axis) {
    const Image image(of, at, step);
    const auto on_place = [&](const Periods& there) { return Vec3(Image(of, there, step).turn().transpose() * force); };
    EXPECT_LT((image.mixed(force, period).col(axis) - difference(on_place, at, axis, period)).norm(), 1e-4);
    for (int first = 0; first < 2; ++first) {
      const auto on_period = [&](const Periods& there) {
        return Vec3(Image(of, there, step).by_period(place, first).transpose() * force);
      };
      const Vec3 both = difference(on_period, at, axis, period);
      EXPECT_LT((image.by_periods(force, place, first, period).col(axis) - both).norm(), 1e-4);
    }
  });
}

TEST(RolledOut, IsTheOtherWayAboutOfRolledUp) {
  for (const double curvature : {0.0, 1e-9, 1e-4, 37.0, -150.0, 700.0}) {
    const Vec3 flat(1e-3, 2e-3, 0.4e-3);
    for (const int around : {0, 1}) {
      const Cylinder on{curvature, around};
      EXPECT_LT((rolled_out(rolled_up(flat, on), on) - flat).norm(), 1e-17) << curvature;
    }
  }
}

TEST(RolledOut, MakesAnImageAShift) {
  for (const PeriodicCell& of : both_ways) {
    const Periods periods = periods_with(300, of);
    const Cylinder on = cylinder(of, periods);
    const Vec3 shift = rolled_out(Image(of, periods, {1, 1})(place), on) - rolled_out(place, on);
    EXPECT_LT((shift - Vec3(periods(0, 0) + periods(0, 1), periods(1, 1), 0)).norm(), 1e-16);
  }
}

TEST(RolledOut, FindsAFabricThatIsNearlyATube) {
  const Cylinder on{900, 1};
  constexpr int points = 20;
  Points q = Points::Zero(3, points + 2);
  for (int k = 0; k < points; ++k) q.col(k) = Vec3(0, k * 0.3e-3, k % 2 * 0.1e-3);
  q.rightCols<2>() = periods_with(on.curvature);
  Points flat = q;
  flat(2, points + 1) = 0;
  for (int k = 0; k < points; ++k) q.col(k) = rolled_up(q.col(k), on);
  EXPECT_LT((rolled_out(cell, q) - flat).norm(), 1e-16);
}

}  // namespace
}  // namespace wale
