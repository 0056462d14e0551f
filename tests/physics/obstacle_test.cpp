#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/spline.hpp"
#include "sim/world.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"
#include "tests/support/solver_runs.hpp"

namespace wale {
namespace {

using std::numbers::pi;

Material thin_yarn() {
  Material thin;
  thin.diameter = 0.2e-3;
  thin.bending_rigidity = 1e-12;
  thin.axial_stiffness = 20;
  return thin;
}

Vec3 force_of(std::string_view name, World& world, const State& at) {
  Points force = Points::Zero(3, at.q.cols());
  Load load{.force = &force};
  world.prepare(at);
  for (const auto& effect : world.effects())
    if (effect->name() == name) effect->add(at, load);
  return force.rowwise().sum();
}

/// A yarn over half a turn of a cylinder about x, both ends hauled down.
struct Draped {
  OneThread one_thread;
  static constexpr double radius = 2e-3, straight = 3e-3, haul = 0.2e-3;
  Fabric fabric;
  Obstacle cylinder{.shape = Obstacle::Shape::cylinder, .axis = {1, 0, 0}, .radius = radius, .stiffness = 1e7};

  Draped() {
    fabric.materials = {thin_yarn()};
    const double bow = radius + fabric.materials[0].diameter / 2, length = bow * pi + 2 * straight;
    const int segments = static_cast<int>(std::lround(length / 0.15e-3));
    Points points(3, segments + 3);
    for (int k = 0; k < segments + 3; ++k) {
      const double s = (k - 1.0) / segments * length - straight;
      const double at = std::clamp(s / bow, 0.0, pi), beyond = s - bow * at;
      points.col(k) = Vec3(0, bow * std::cos(at) - beyond * std::sin(at), bow * std::sin(at) + beyond * std::cos(at));
    }
    add_yarn(fabric, points, length / segments);
  }
};

TEST(Obstacle, IsPressedByTheTensionOverTheRadiusOfAYarnThatLiesOverACylinder) {
  const Draped draped;
  const Fabric& fabric = draped.fabric;
  const Schedule ramp = Schedule::ramp(0, 1, 1);
  const Tether left{
      .label = "left", .segments = {0}, .stiffness = 1e9, .move = {0, 0, -Draped::haul}, .progress = ramp};
  const Tether right{.label = "right",
                     .segments = {fabric.segment_count() - 1},
                     .stiffness = 1e9,
                     .move = {0, 0, -Draped::haul},
                     .progress = ramp};
  World world(fabric, {Stretch{}, Bend{}, draped.cylinder, left, right}, 0.0, at_rest(fabric));
  const auto solver = make(QuasiStatic{.tolerance = 1e-2}, world, at_rest(fabric));
  const State hauled = run_to(*solver, 1);

  const double tension = -force_of("left", world, hauled).z();
  EXPECT_GT(tension, 0.1);
  EXPECT_NEAR(force_of("right", world, hauled).z(), -tension, 1e-4 * tension);
  EXPECT_NEAR(force_of("obstacle", world, hauled).z(), 2 * tension, 1e-4 * tension);
  const double d = fabric.materials[0].diameter;
  double least = 1, most = 0;
  for (int i = fabric.segment_count() * 2 / 5; i < fabric.segment_count() * 3 / 5; ++i)
    for (const GaussNode& node : gauss(3)) {
      const double bow = combine(hauled.q, i, basis(node.s).value).norm();
      const double pressed = 2 * draped.cylinder.stiffness * (Draped::radius + d / 2 - bow);  // per length as laid
      // A length as laid is longer now.
      const double expected = tension / bow * (1 + tension / fabric.materials[0].axial_stiffness);
      least = std::min(least, pressed / expected);
      most = std::max(most, pressed / expected);
    }
  EXPECT_GT(least, 0.99);
  EXPECT_LT(most, 1.01);
}

/// A yarn between two clamps, pushed aside by a ball: two tangents and an arc, all under one tension.
TEST(Obstacle, PushesAYarnAsideAsABallDoesThatMovesIntoIt) {
  const OneThread one_thread;
  const double half = 10e-3, radius = 4e-3, push = 2e-3;
  const Fabric fabric = straight_rod(2 * half, 120, thin_yarn());
  const double d = fabric.materials[0].diameter, reach = radius + d / 2;
  const Obstacle ball{.shape = Obstacle::Shape::sphere,
                      .centre = {half, 0, -reach},
                      .radius = radius,
                      .stiffness = 1e7,
                      .move = {0, 0, push},
                      .progress = Schedule::ramp(0, 1, 1)};
  World world(fabric, {Stretch{}, Bend{}, ball}, 0.0, at_rest(fabric), {{.yarn = 0}, {.yarn = 0, .at_end = true}});
  const auto solver = make(QuasiStatic{.tolerance = 1e-2, .first_step = 0.1}, world, at_rest(fabric));
  const State pushed = run_to(*solver, 1);

  const double below = reach - push;  // of the ball's centre
  const double tangent = std::sqrt(half * half + below * below - reach * reach);
  const double lean = std::atan2(reach, tangent) - std::atan2(below, half);
  const double length = 2 * (tangent + reach * lean);
  const double tension = fabric.materials[0].axial_stiffness * (length / (2 * half) - 1);
  const Vec3 force = force_of("obstacle", world, pushed);
  EXPECT_NEAR(force.z(), 2 * tension * std::sin(lean), 0.01 * force.z());
  EXPECT_LT(std::abs(force.x()) + std::abs(force.y()), 1e-3 * force.z());
}

TEST(Obstacle, CarriesAYarnsWeightAndLetsItSinkInByThatOverTwiceItsStiffness) {
  const OneThread one_thread;
  const double g = 9810;
  const Fabric fabric = straight_rod(10e-3, 16);
  const Material& yarn = fabric.materials[0];
  const Obstacle table{.centre = {3e-3, 0, -yarn.diameter / 2}, .stiffness = 1e4};
  World world(fabric, {Stretch{}, Bend{}, Gravity{{0, 0, -g}}, table}, 0.0, at_rest(fabric));
  const auto solver = make(QuasiStatic{.tolerance = 1e-5}, world, at_rest(fabric));
  const State rests = run_to(*solver, 1);
  const double weight = yarn.linear_density * g;
  EXPECT_NEAR(force_of("obstacle", world, rests).z(), weight * 10e-3, 1e-4 * weight * 10e-3);
  for (int i = 0; i < fabric.segment_count(); ++i)
    EXPECT_NEAR(combine(rests.q, i, basis(0.5).value).z(), -weight / (2 * table.stiffness), 1e-3 * 38e-6) << i;
}

}  // namespace
}  // namespace wale
