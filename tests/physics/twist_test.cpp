#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compiler/compile.hpp"
#include "sim/run.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/modes.hpp"
#include "tests/support/one_thread.hpp"

namespace wale {
namespace {

using std::numbers::pi;

double energy_of(const Twist& twist, const Fabric& fabric, const State& start, const Points& q) {
  World world(fabric, {twist}, 0.0, start);
  State at = start;
  at.q = q;
  double energy = 0;
  Load load{.energy = &energy};
  world.evaluate(at, load);
  return energy;
}

Points helix(double radius, double rise, int around, int turns, double side) {
  Points points(3, around * turns + 3);
  for (int k = 0; k < points.cols(); ++k) {
    const double angle = 2 * pi * (k - 1) / around;
    points.col(k) = Vec3(rise * angle / (2 * pi), radius * std::cos(angle), side * radius * std::sin(angle));
  }
  return points;
}

/// Against the straight line along its axis a helix of n turns has the writhe n (1 - sin of its rise's angle). The
/// spline runs within its control points.
TEST(Twist, DrivesAYarnIntoAHelixOfItsOwnHand) {
  const double radius = 0.5e-3, rise = 2e-3;
  const int around = 60, turns = 4;
  const double within = (2 + std::cos(2 * pi / around)) / 3;
  const double angle = std::atan2(rise, 2 * pi * within * radius), writhe = turns * (1 - std::sin(angle));
  for (const double side : {1, -1}) {
    Fabric fabric;
    fabric.materials = {Material{}};
    const Points points = helix(radius, rise, around, turns, side);
    add_yarn(fabric, straight_points({0, 0, 0}, {rise * turns, 0, 0}, around * turns), rise / around);
    const double energy = energy_of(Twist{.to = 1e-6}, fabric, at_rest(fabric), points);
    EXPECT_NEAR(energy, -1e-6 * 2 * pi * side * writhe, 1e-4 * 1e-6 * 2 * pi * writhe);
  }
}

/// The torque at which a straight rod between two clamps stops being stable, as M L/EI.
double buckling_torque(double guess) {
  const double L = 0.02;
  const Fabric fabric = straight_rod(L, 24);
  const double unit = fabric.materials[0].bending_rigidity / L;
  double stable = 0.5 * guess, unstable = 2 * guess;
  while (unstable - stable > 1e-4 * guess) {
    const double torque = (stable + unstable) / 2;
    World world(fabric, {Stretch{.nodes = 3}, Bend{}, Twist{.to = torque * unit}}, 0.0, at_rest(fabric),
                {{.yarn = 0, .direction = true}, {.yarn = 0, .at_end = true, .direction = true}});
    (squared_frequencies(world, at_rest(fabric))[0] > 0 ? stable : unstable) = torque;
  }
  return stable;
}

/// Greenhill 1883: tan(M L / 2 EI) = M L / 2 EI.
TEST(Twist, BucklesAClampedRodUnderGreenhillsTorque) { EXPECT_NEAR(buckling_torque(8.98682), 8.98682, 2e-3 * 8.98682); }

/// How far the wales of jersey without end lean along the courses, over their height, under a torque in its yarn.
double lean_of_jersey(const std::string& torque) {
  Sources sources;
  Diagnostics say;
  const auto scene =
      compile_scene(*sources.add(WALE_SOURCE_DIR "/scene.yaml",
                                 "scene: 1\n"
                                 "fabric: {pattern: patterns/jersey.yaml, wales: 1, courses: 1, periodic: true}\n"
                                 "effects: {stretch: , bend: , contact: }\n"
                                 "stages:\n"
                                 "  - {name: tighten, duration: 1 s, tighten: 100 %, samples: 2}\n"
                                 "  - {name: spiral, duration: 1 s, samples: 2, effects: {twist: {to: " +
                                     torque + "}}}\nsolver: {quasi_static: {tolerance: 1e-4}}\n"),
                    sources, say);
  Results results;
  results.scene = scene.value();
  EXPECT_EQ(run(results, {}), Outcome::finished) << results.effort.failure;
  const auto periods = results.snapshots.back().state.q.rightCols<2>();
  return periods(0, 1) / periods(1, 1);
}

TEST(Twist, LeansTheWalesOfJerseyToTheSideOfItsHand) {
  const OneThread one_thread;
  const double right = lean_of_jersey("2e-6 N m"), left = lean_of_jersey("-2e-6 N m"), none = lean_of_jersey("0 N m");
  EXPECT_GT(right, 0.01);
  EXPECT_NEAR(left, -right, 0.01 * right);
  EXPECT_NEAR(none, 0, 1e-3 * right);
}

}  // namespace
}  // namespace wale
