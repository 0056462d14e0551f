#include <gtest/gtest.h>

#include "sim/results/stretch_strain.hpp"
#include "sim/run.hpp"
#include "sim/spline.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"

namespace wale {
namespace {

constexpr double length = 10e-3;
constexpr int segments = 16;

Stage shrinking(std::vector<Shrink> shrink) {
  Stage stage;
  stage.samples = 2;
  stage.shrink = std::move(shrink);
  stage.effects = {Stretch{}, Bend{}};
  stage.solver = QuasiStatic{.tolerance = 1e-6};
  return stage;
}

Results results_of(Fabric fabric, std::vector<Stage> stages) {
  const OneThread one_thread;
  Results results;
  results.scene.fabric = std::move(fabric);
  results.scene.stages = std::move(stages);
  EXPECT_EQ(run(results, {}), Outcome::finished) << results.effort.failure;
  return results;
}

/// From the start of a yarn to its end along x.
double reach(const Fabric& fabric, const Points& q, int yarn) {
  const Yarn& of = fabric.yarns[static_cast<std::size_t>(yarn)];
  return (combine(q, of.first_point + of.segments - 1, basis(1).value) - combine(q, of.first_point, basis(0).value))
      .x();
}

TEST(Shrink, ShortensAFreeYarnByExactlyThat) {
  const Results results = results_of(straight_rod(length, segments), {shrinking({{{}, 0.2}})});
  ASSERT_EQ(results.snapshots.size(), 3U);
  EXPECT_NEAR(reach(results.scene.fabric, results.snapshots[1].state.q, 0), 0.9 * length, 1e-8 * length);
  EXPECT_NEAR(reach(results.scene.fabric, results.snapshots[2].state.q, 0), 0.8 * length, 1e-8 * length);
}

TEST(Shrink, LastsUntilAStageSaysOtherwise) {
  Stage rest = shrinking({}), back = shrinking({{{}, 0}});
  rest.samples = back.samples = 1;
  const Results results = results_of(straight_rod(length, segments), {shrinking({{{}, 0.2}}), rest, back});
  const auto reach_after = [&](int stage) {
    double last = 0;
    for (const Snapshot& snapshot : results.snapshots)
      if (snapshot.stage == stage) last = reach(results.scene.fabric, snapshot.state.q, 0);
    return last;
  };
  EXPECT_NEAR(reach_after(1), 0.8 * length, 1e-8 * length);
  EXPECT_NEAR(reach_after(2), length, 1e-8 * length);
  for (const Snapshot& snapshot : results.snapshots)
    for (const double strain :
         stretch_strains(results.scene.fabric, snapshot.state.q, rest_lengths_at(results.scene, snapshot)))
      EXPECT_NEAR(strain, 0, 1e-7);
}

TEST(Shrink, TakesHeldEndsAlong) {
  const OneThread one_thread;
  Stage stage = shrinking({{{}, 0.2}});
  stage.hold = Hold::ends;
  Results results;
  results.scene.fabric = straight_rod(length, segments);
  results.scene.gauge.wale_ends = {{{0}, {segments - 1}}};
  results.scene.stages = {stage};
  ASSERT_EQ(run(results, {}), Outcome::finished) << results.effort.failure;
  EXPECT_NEAR(reach(results.scene.fabric, results.snapshots.back().state.q, 0), 0.8 * length, 1e-8 * length);
}

/// Two yarns side by side, tied at both ends; the first of them shrinks.
TEST(Shrink, SharesItsLoadWithTheYarnThatItIsTiedToByTheirStiffnesses) {
  Fabric fabric;
  // So stiff that the one which is pressed does not buckle.
  fabric.materials = {{.name = "active", .axial_stiffness = 30, .bending_rigidity = 1e-4},
                      {.name = "passive", .axial_stiffness = 90, .bending_rigidity = 1e-4}};
  const double apart = 1e-7;
  add_yarn(fabric, straight_points({0, 0, 0}, {length, 0, 0}, segments), length / segments, 0);
  add_yarn(fabric, straight_points({0, apart, 0}, {length, apart, 0}, segments), length / segments, 1);
  Stage stage = shrinking({{{0}, 0.1}});
  stage.effects.emplace_back(
      Knots{.knots = {{0, segments, 0, 0, apart}, {segments - 1, 2 * segments - 1, 1, 1, apart}}, .stiffness = 1e8});
  stage.samples = 1;
  stage.solver = QuasiStatic{.tolerance = 1e-8};
  const Results results = results_of(fabric, {stage});
  // EA_1 (L / (0.9 L_0) - 1) + EA_2 (L / L_0 - 1) = 0
  const double expected = (30.0 + 90) / (30 / 0.9 + 90) * length;
  for (const int yarn : {0, 1})
    EXPECT_NEAR(reach(fabric, results.snapshots.back().state.q, yarn), expected, 3e-4 * length) << yarn;
}

}  // namespace
}  // namespace wale
