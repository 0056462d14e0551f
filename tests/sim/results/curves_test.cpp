#include "sim/results/curves.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "sim/results/recorder.hpp"
#include "tests/sim/results/made_jersey.hpp"

namespace wale {
namespace {

/// Two straight lines that meet at 30 % strain: 0.2 MPa and 2 MPa, with a prestress of 1 kPa.
Curve two_lines(int samples, double to) {
  Curve curve;
  for (int i = 0; i <= samples; ++i) {
    const double strain = to * i / samples;
    curve.strain.push_back(strain);
    curve.stress.push_back(1e3 + 0.2e6 * strain + std::max(0.0, 1.8e6 * (strain - 0.3)));
  }
  return curve;
}

TEST(Features, AreTheSlopesAndTheKneeOfTwoLines) {
  const Features found = features(two_lines(60, 0.6));
  EXPECT_NEAR(found.initial_stiffness, 0.2e6, 1);
  EXPECT_NEAR(found.final_stiffness, 2e6, 1);
  EXPECT_NEAR(found.transition_strain, 0.3, 1e-9);
}

TEST(Features, NeedOnlyTwoSamplesAPart) {
  const Features found = features(two_lines(3, 0.9));
  EXPECT_NEAR(found.initial_stiffness, 0.2e6, 1);
  EXPECT_NEAR(found.final_stiffness, 2e6, 1);
}

TEST(Features, OfASmoothCurveLieWhereItsTangentsSay) {
  Curve curve;
  for (int i = 0; i <= 600; ++i) {
    curve.strain.push_back(i * 1e-3);
    curve.stress.push_back(std::exp(10 * i * 1e-3));
  }
  const Features found = features(curve);
  EXPECT_GT(found.initial_stiffness, 10);
  EXPECT_LT(found.initial_stiffness, 10 * std::exp(1));
  EXPECT_GT(found.final_stiffness, 10 * std::exp(5));
  EXPECT_LT(found.final_stiffness, 10 * std::exp(6));
  EXPECT_GT(found.transition_strain, 0.4);
  EXPECT_LT(found.transition_strain, 0.5);
}

TEST(Features, AreUnknownWhereTheCurveDoesNotTell) {
  EXPECT_TRUE(std::isnan(features({}).initial_stiffness));
  Curve straight;
  for (int i = 0; i <= 10; ++i) straight.strain.push_back(0.05 * i), straight.stress.push_back(1e4 * i);
  const Features found = features(straight);
  EXPECT_NEAR(found.initial_stiffness, 2e5, 1e-3);
  EXPECT_FALSE(found.transition_strain > 0 && found.transition_strain < 0.5 && found.final_stiffness > 2.001e5);
  Curve lacking;
  lacking.strain = {0, 0.1};
  lacking.stress = {0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_TRUE(std::isnan(features(lacking).final_stiffness));
}

TEST(Curve, IsMadeOfTheSamplesOfTheLastPulledStage) {
  Results results;
  append_row(results.samples, {{"stage", "", 0}, {"t", "s", 1}});
  for (int stage = 1; stage <= 2; ++stage)
    for (int i = 0; i < 3; ++i)
      append_row(results.samples,
                 {{"stage", "", 1.0 * stage}, {"strain", "", 0.1 * i * stage}, {"stress", "Pa", 5.0 * i}});
  append_row(results.samples, {{"stage", "", 3}, {"t", "s", 9}});
  const Curve curve = stress_strain(results);
  EXPECT_EQ(curve.strain, (std::vector<double>{0, 0.2, 0.4}));
  EXPECT_EQ(curve.stress, (std::vector<double>{0, 5, 10}));
  ASSERT_EQ(curve.force.size(), 3U);
  EXPECT_TRUE(std::isnan(curve.force[0]));
}

TEST(Features, OfAPullToAndFroAreThoseOfItsFirstWay) {
  Curve curve = two_lines(60, 0.6);
  const Features out = features(curve);
  for (std::size_t i = 60; i-- > 0;) {
    curve.strain.push_back(curve.strain[i]);
    curve.stress.push_back(0.1 * curve.stress[i]);
  }
  const Features to_and_fro = features(curve);
  EXPECT_EQ(to_and_fro.initial_stiffness, out.initial_stiffness);
  EXPECT_EQ(to_and_fro.transition_strain, out.transition_strain);
  EXPECT_EQ(to_and_fro.final_stiffness, out.final_stiffness);
}

/// A stage that only relaxes, and one that shears to 0.2 and back while the wales shorten.
Results sheared() {
  Results results;
  append_row(results.samples, {{"stage", "", 0}, {"stress.wale", "Pa", 9}});
  for (const double shear : {0.0, 0.1, 0.2, 0.1})
    append_row(results.samples, {{"stage", "", 1},
                                 {"stress.wale", "Pa", 0},
                                 {"stress.course", "Pa", 1},
                                 {"stress.shear", "Pa", 50 * shear},
                                 {"strain.course", "", 0},
                                 {"strain.wale", "", -shear / 10},
                                 {"strain.shear", "", shear}});
  return results;
}

TEST(Curve, OfADeformationIsOneForEachDirection) {
  const Results results = sheared();
  EXPECT_EQ(strained_rows(results.samples), (std::vector<std::size_t>{1, 2, 3, 4}));
  EXPECT_TRUE(stress_strain(results).strain.empty());
  const std::vector<LabelledCurve> curves = stress_strain_curves(results);
  ASSERT_EQ(curves.size(), 3U);
  EXPECT_EQ(curves[0].label, "wale");
  EXPECT_EQ(curves[2].label, "shear");
  EXPECT_EQ(curves[2].curve.strain, (std::vector<double>{0, 0.1, 0.2, 0.1}));
  EXPECT_EQ(curves[2].curve.stress, (std::vector<double>{0, 5, 10, 5}));
}

TEST(Curve, KnowsWhereItIsStrainedMost) {
  EXPECT_EQ(most_strained_row(sheared().samples), 3U);
  Results pulled;
  EXPECT_EQ(most_strained_row(pulled.samples), std::nullopt);
  for (const double strain : {0.0, 0.3, 0.0, 0.3, 0.1})
    append_row(pulled.samples, {{"stage", "", 0}, {"strain", "", strain}});
  EXPECT_EQ(most_strained_row(pulled.samples), 3U);
}

void expect_sizes(const Sizes& sizes, const testing::MadeJersey& made, int wales, int courses) {
  EXPECT_NEAR(sizes.wale_spacing, made.wale_spacing, 1e-3 * made.wale_spacing);
  EXPECT_NEAR(sizes.course_spacing, made.course_spacing, 1e-3 * made.course_spacing);
  EXPECT_NEAR(sizes.width, wales * made.wale_spacing, 1e-3 * sizes.width);
  EXPECT_NEAR(sizes.length, courses * made.course_spacing, 1e-3 * sizes.length);
  // z = -0.76 d cos(pi w) spends a tenth of w beyond cos(0.05 pi) of its extremes, and the spline through control
  // points a quarter of w apart has (4 + 2 cos(pi / 4)) / 6 of their amplitude.
  const double amplitude = 0.76 * (4 + 2 * std::cos(std::numbers::pi / 4)) / 6 * std::cos(0.05 * std::numbers::pi);
  EXPECT_NEAR(sizes.thickness, made.diameter * (1 + 2 * amplitude), 0.02 * made.diameter);
}

TEST(Measure, FindsTheSpacingsOfARegularFabricInAnyPose) {
  const testing::MadeJersey made = testing::made_jersey(7, 5);
  expect_sizes(measure(made.fabric, made.gauge, made.fabric.points), made, 7, 5);
  const Mat3 turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized().toRotationMatrix();
  expect_sizes(measure(made.fabric, made.gauge, turn * made.fabric.points), made, 7, 5);
}

TEST(Measure, FindsTheWaleSpacingOfATubeAlongItsCourses) {
  testing::MadeJersey made = testing::made_jersey(24, 5);
  const double girth = 24 * made.wale_spacing, radius = girth / (2 * std::numbers::pi);
  for (Eigen::Index i = 0; i < made.fabric.points.cols(); ++i) {
    Vec3 p = made.fabric.points.col(i);
    const double angle = p.x() / radius;
    made.fabric.points.col(i) = Vec3(radius * std::sin(angle), p.y(), (radius + p.z()) * std::cos(angle) - radius);
  }
  made.gauge.course_ends = {};
  const Sizes sizes = measure(made.fabric, made.gauge, made.fabric.points);
  EXPECT_NEAR(sizes.width, girth, 0.03 * girth);
  EXPECT_NEAR(sizes.course_spacing, made.course_spacing, 1e-3 * made.course_spacing);
}

TEST(Measure, SaysNothingOfAFabricWithoutGrips) {
  const testing::MadeJersey made = testing::made_jersey(3, 3);
  const Sizes sizes = measure(made.fabric, {}, made.fabric.points);
  EXPECT_EQ(sizes.width, 0);
  EXPECT_EQ(sizes.length, 0);
  EXPECT_GT(sizes.thickness, made.diameter);
}

}  // namespace
}  // namespace wale
