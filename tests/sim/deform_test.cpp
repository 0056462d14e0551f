#include "sim/deform.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/stage.hpp"
#include "tests/support/make_fabric.hpp"

namespace wale {
namespace {

using Knots = std::vector<Schedule::Knot>;
using How = Deform::How;

TEST(Strain, OfAPullGoesToAndFroAtConstantSpeed) {
  const Schedule strain = strain_of(Pull{Along::wale, {0.6, 0, 0.3, 0.2}}, 8);
  const double speed = 1.6 / 8;
  EXPECT_DOUBLE_EQ(strain(0), 0);
  EXPECT_DOUBLE_EQ(strain(0.3 / speed), 0.3);
  EXPECT_DOUBLE_EQ(strain(0.6 / speed), 0.6);
  EXPECT_NEAR(strain(1.0 / speed), 0.2, 1e-15);
  EXPECT_NEAR(strain(1.2 / speed), 0, 1e-15);
  EXPECT_DOUBLE_EQ(strain(8), 0.2);
}

TEST(Strain, OfASimplePullIsARamp) { EXPECT_EQ(strain_of(Pull{Along::course, {0.6}}, 8), Schedule::ramp(0, 0.6, 8)); }

TEST(Strain, OfDrivenPartsArriveTogether) {
  Deform deform;
  deform.wale = {How::driven, {0.3, 0.3}};
  deform.shear = {How::driven, {0.4, -0.1}};
  deform.course = {How::held, {}};
  EXPECT_EQ(strain_of(deform, deform.wale, 2).knots(), (Knots{{0, 0}, {1, 0.3}, {2, 0.3}}));
  EXPECT_EQ(strain_of(deform, deform.shear, 2).knots(), (Knots{{0, 0}, {1, 0.4}, {2, -0.1}}));
}

TEST(Deform, OfAStageIsWhatItSaysOrWhatItsPullMeans) {
  Stage stage;
  EXPECT_EQ(deform_of(stage), Deform{});
  stage.hold = Hold::periods;
  for (const Deform::Part& part : {deform_of(stage).wale, deform_of(stage).course, deform_of(stage).shear})
    EXPECT_EQ(part.how, How::held);
  stage.hold = Hold::none;
  stage.pull = Pull{Along::course, {0.2, 0}};
  Deform pulled;
  pulled.course = {How::driven, {0.2, 0}};
  EXPECT_EQ(deform_of(stage), pulled);
  stage.pull.reset();
  stage.deform = Deform{.wale = {How::held, {}}, .shear = {How::driven, {0.1}}};
  EXPECT_EQ(deform_of(stage), *stage.deform);
}

TEST(Schedule, TimesAFactorIsThatInEveryKnot) {
  EXPECT_EQ(Schedule({{0, 1}, {2, -3}}).times(2), Schedule({{0, 2}, {2, -6}}));
}

double column(const std::vector<Quantity>& row, const std::string& name) {
  for (const Quantity& one : row)
    if (one.name == name) return one.value;
  ADD_FAILURE() << "no " << name;
  return std::nan("");
}

/// What the table says of a rod between two grips that go 20 mm apart and half of the way back.
TEST(Stage, RecordsTheStrainOfAPullToAndFro) {
  Scene scene;
  scene.fabric = straight_rod(0.1, 10);
  scene.gauge = {.wale_ends = {}, .course_ends = {{{0}, {9}}}, .wales = 1, .courses = 1, .thickness = 1e-3};
  Stage stage;
  stage.duration = 3;
  stage.pull = Pull{Along::course, {0.2, 0.1}};
  const Points& q = scene.fabric.points;
  State state{.t = 0, .q = q, .v = Points::Zero(3, q.cols()), .step = 0};
  const StageSetup setup(scene, stage, state, 0, Sizes{.width = 1, .length = 1});
  const auto world = setup.world();
  const std::vector<std::pair<double, double>> rows{{0, 0}, {1, 0.1}, {2, 0.2}, {2.5, 0.15}, {3, 0.1}};
  for (const auto& [t, strain] : rows) {
    state.t = t;
    EXPECT_NEAR(column(setup.measure(*world, state), "strain"), strain, 1e-15) << t;
  }
}

TEST(Turns, AreWhereStrainsTurnAndNowhereInARest) {
  Stage stage;
  stage.duration = 3;
  EXPECT_TRUE(turns_of(stage).empty());
  stage.pull = Pull{Along::course, {0.2, 0.1}};
  EXPECT_EQ(turns_of(stage), (std::vector<double>{0, 2, 3}));
  stage.pull.reset();
  stage.deform = Deform{.course = {Deform::How::driven, {0.3, 0}}, .shear = {Deform::How::driven, {0.4, 0.4}}};
  ASSERT_EQ(turns_of(stage).size(), 3u);
  EXPECT_DOUBLE_EQ(turns_of(stage)[1], 3 * 0.5 / 0.8) << "0.5 there and 0.3 back";
}

}  // namespace
}  // namespace wale
