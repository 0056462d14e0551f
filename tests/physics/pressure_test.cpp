#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compiler/compile.hpp"
#include "sim/results/results.hpp"
#include "sim/run.hpp"
#include "sim/spline.hpp"
#include "sim/turns.hpp"
#include "sim/world.hpp"
#include "tests/support/circle.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"
#include "tests/support/solver_runs.hpp"

namespace wale {
namespace {

using std::numbers::pi;

constexpr double radius = 3e-3, height = 1e-3;
const Vec3 axis = Vec3::UnitZ();

Fabric ring(int segments) {
  Fabric fabric;
  fabric.materials = {Material{}};
  add_yarn(fabric, circle_points(radius, segments), 2 * pi * radius / segments);
  return fabric;
}

/// Held in one point, with its direction there, as half of the ring by symmetry would be.
TEST(Pressure, StretchesARingOfYarnByItselfTimesHeightAndRadius) {
  const OneThread one_thread;
  const Fabric fabric = ring(48);
  const Pressure inflate{.to = 1e6, .axis = axis, .spacing = height, .progress = Schedule::ramp(0, 1, 1)};
  World world(fabric, {Stretch{}, Bend{}, inflate}, 0.0, at_rest(fabric),
              {{.yarn = 0, .direction = true}, {.yarn = 0, .at_end = true, .direction = true}});
  const auto solver = make(QuasiStatic{.tolerance = 1e-4, .first_step = 0.25}, world, at_rest(fabric));
  const State blown = run_to(*solver, 1);
  double left = 0, right = 0;
  for (int i = 0; i < fabric.segment_count(); ++i) {
    const double x = combine(blown.q, i, basis(0).value).x();
    left = std::min(left, x);
    right = std::max(right, x);
  }
  const double EA = fabric.materials[0].axial_stiffness;
  // T = EA (R / R_0 - 1) = p h R
  const double expected = radius / (1 - 1e6 * height * radius / EA);
  EXPECT_GT(expected, 1.04 * radius);
  EXPECT_NEAR((right - left) / 2, expected, 2e-3 * expected);
}

TEST(Pressure, BlowsUpWhicheverWayTheYarnGoesRound) {
  const Fabric fabric = ring(24);
  for (const double side : {1, -1}) {
    Fabric turned = fabric;
    turned.points.row(1) *= side;
    World world(turned, {Pressure{.to = 100, .axis = axis, .spacing = height}}, 0.0, at_rest(turned));
    Points force;
    double energy = 0;
    Load load{.energy = &energy, .force = &force};
    world.evaluate(at_rest(turned), load);
    EXPECT_NEAR(energy, -100 * height * pi * radius * radius, 1e-4 * -energy);
    // The area grows by the square: twice the energy for the motion that doubles the ring.
    EXPECT_NEAR(force.cwiseProduct(turned.points).sum(), -2 * energy, 1e-12);
  }
}

TEST(Pressure, FindsTheHeightOfATurnOfAHelix) {
  Fabric fabric;
  fabric.materials = {Material{}};
  const int around = 40, turns = 5;
  const double within = (2 + std::cos(2 * pi / around)) / 3;  // of the spline, to its control points
  Points points(3, around * turns + 3);
  for (int k = 0; k < points.cols(); ++k)
    points.col(k) = Vec3(radius / within * std::cos(2 * pi * k / around), height * k / around,
                         -radius / within * std::sin(2 * pi * k / around));
  add_yarn(fabric, points, 2 * pi * radius / around);
  const Turns found = turns_about(fabric, fabric.points, Vec3::UnitY());
  EXPECT_NEAR(found.count, turns, 0.05);
  EXPECT_NEAR(found.extent / found.count, height, 1e-3 * height);
  double energy = 0;
  Load load{.energy = &energy};
  World world(fabric, {Pressure{.to = 1}}, 0.0, at_rest(fabric));
  world.evaluate(at_rest(fabric), load);
  EXPECT_NEAR(-energy, pi * radius * radius * height * turns, 5e-3 * -energy);
}

/// From the axis to the yarn, the mean, m.
double mean_radius(const Points& q) {
  const Vec3 centre = q.rowwise().mean();
  double sum = 0;
  for (Eigen::Index k = 0; k < q.cols(); ++k) sum += std::hypot(q(0, k) - centre.x(), q(2, k) - centre.z());
  return sum / static_cast<double>(q.cols());
}

TEST(Pressure, BlowsUpAKnittedTube) {
  const OneThread one_thread;
  Sources sources;
  Diagnostics say;
  sources.add("tube.yaml", "knit: 1\nform: tube\nwales: 12\nbands: [{stitch: jersey, courses: 6}]\n");
  const auto scene = compile_scene(
      *sources.add("scene.yaml",
                   "scene: 1\nfabric: {pattern: tube.yaml, segments_per_stitch: 10}\n"
                   "effects: {stretch: , bend: , contact: , knots: }\nstages:\n"
                   "  - {name: tighten, duration: 1 s, tighten: 100 %, hold: ends, samples: 1}\n"
                   "  - {name: blow, duration: 1 s, hold: ends, samples: 2, effects: {pressure: {to: 100 kPa}}}\n"
                   "solver: {quasi_static: {tolerance: 0.5}}\n"),
      sources, say);
  for (const Diagnostic& one : say.all()) ADD_FAILURE() << print(one);
  ASSERT_TRUE(scene);
  Results results;
  results.scene = *scene;
  ASSERT_EQ(run(results, {}), Outcome::finished) << results.effort.failure;
  const auto& snapshots = results.snapshots;
  const double before = mean_radius(snapshots[snapshots.size() - 3].state.q),
               after = mean_radius(snapshots.back().state.q);
  EXPECT_GT(after, 1.1 * before);
  EXPECT_TRUE(results.topology.intact());
}

}  // namespace
}  // namespace wale
