#include "sim/image.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace wale {
namespace {

const PeriodicCell cell{.course = {3e-3, 0, 0}, .wale = {0, 2e-3, 0}, .curls = Curls::about_courses};
const Vec3 place(0.4e-3, 0.7e-3, -0.3e-3), force(0.3, -0.2, 0.5);

Periods periods_with(double curvature) {
  Periods periods;
  periods << 3.1e-3, 0.4e-3, 0, 2.2e-3, 0, curvature * curl_unit(cell);
  return periods;
}

const std::array<Eigen::Vector2i, 4> steps{{{0, 1}, {1, 1}, {-2, 3}, {1, 0}}};
const std::array<double, 5> curvatures{0, 1e-4, 37, -150, 700};  // 1/m

/// Central difference of `of` by coordinate `axis` of a period.
template <class Of>
auto difference(const Of& of, double curvature, int axis, int period) {
  const double step = 1e-7;
  Periods ahead = periods_with(curvature), behind = ahead;
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

TEST(Image, HasTheDerivativesOfItsPlace) {
  for (const double curvature : curvatures)
    for (const Eigen::Vector2i& step : steps) {
      const Image image(cell, periods_with(curvature), step);
      for (int period = 0; period < 2; ++period)
        for (int axis = 0; axis < 3; ++axis) {
          if (axis == 2 && period == 0) continue;  // is 0 always
          const Vec3 by =
              difference([&](const Periods& at) { return Image(cell, at, step)(place); }, curvature, axis, period);
          EXPECT_LT((image.by_period(place, period).col(axis) - by).norm(), 2e-7) << curvature << step.transpose();
        }
    }
}

TEST(Image, HasTheSecondDerivativesOfItsPlace) {
  for (const double curvature : curvatures)
    for (const Eigen::Vector2i& step : steps) {
      const Image image(cell, periods_with(curvature), step);
      for (int period = 0; period < 2; ++period)
        for (int axis = 0; axis < 3; ++axis) {
          if (axis == 2 && period == 0) continue;
          const Vec3 mixed =
              difference([&](const Periods& at) { return Vec3(Image(cell, at, step).turn().transpose() * force); },
                         curvature, axis, period);
          EXPECT_LT((image.mixed(force, period).col(axis) - mixed).norm(), 1e-4) << curvature;
          for (int first = 0; first < 2; ++first) {
            const Vec3 both = difference(
                [&](const Periods& at) {
                  return Vec3(Image(cell, at, step).by_period(place, first).transpose() * force);
                },
                curvature, axis, period);
            EXPECT_LT((image.by_periods(force, place, first, period).col(axis) - both).norm(), 1e-4) << curvature;
          }
        }
    }
}

TEST(RolledOut, IsTheOtherWayAboutOfRolledUp) {
  for (const double curvature : {0.0, 1e-9, 1e-4, 37.0, -150.0, 700.0}) {
    const Vec3 flat(1e-3, 2e-3, 0.4e-3);
    EXPECT_LT((rolled_out(rolled_up(flat, curvature), curvature) - flat).norm(), 1e-17) << curvature;
  }
}

TEST(RolledOut, MakesAnImageAShift) {
  const double curvature = 300;
  const Periods periods = periods_with(curvature);
  const Image image(cell, periods, {1, 1});
  const Vec3 shift = rolled_out(image(place), curvature) - rolled_out(place, curvature);
  EXPECT_LT((shift - Vec3(periods(0, 0) + periods(0, 1), periods(1, 1), 0)).norm(), 1e-16);
}

}  // namespace
}  // namespace wale
