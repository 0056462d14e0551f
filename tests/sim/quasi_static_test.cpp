#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/solver.hpp"
#include "tests/support/one_thread.hpp"
#include "tests/support/run_scene.hpp"

namespace wale {
namespace {

constexpr double tolerance = 0.5;  // see QuasiStatic

/// A swatch of jersey tightened between held ends, and what its solver left at each step.
struct Tightened {
  Results results;
  std::vector<double> residuals;  // N; the last one is that of the sample
  double allowed() const { return allowed_residual(QuasiStatic{.tolerance = tolerance}, results.scene.fabric); }
};

Tightened tighten(const std::string& effects) {
  const OneThread one_thread;
  Tightened made;
  RunOptions options;
  options.progress = [&](const RunStatus& status) { made.residuals.push_back(*status.residual); };
  made.results = run_scene(fmt::format(R"(scene: 1
fabric: {{pattern: jersey.yaml, wales: 10, courses: 10, segments_per_stitch: 10}}
effects: {{stretch: , bend: , contact: , knots: , {}}}
stages:
  - {{name: tighten, tighten: 100 %, hold: ends, duration: 1 s, samples: 1}}
solver: {{quasi_static: {{tolerance: {}, first_step: 2 %}}}}
)",
                                       effects, tolerance),
                           options);
  return made;
}

/// What still slides on the way would hold up all of a large fabric; without friction it makes no difference later.
TEST(QuasiStatic, LeavesAFewPlacesOutOfBalanceBetweenSamplesOnly) {
  const Tightened jersey = tighten("");
  EXPECT_GT(*std::max_element(jersey.residuals.begin(), jersey.residuals.end()), jersey.allowed());
  EXPECT_LE(jersey.residuals.back(), jersey.allowed());
}

TEST(QuasiStatic, LeavesNothingOutOfBalanceThatFrictionWouldRemember) {
  const Tightened jersey = tighten("friction: ");
  EXPECT_GT(jersey.residuals.size(), 3);
  for (const double residual : jersey.residuals) EXPECT_LE(residual, jersey.allowed());
}

/// How far through the stage every step ends, of one sample under a load that stays.
std::vector<double> stops(const std::string& first_step) {
  const OneThread one_thread;
  std::vector<double> made;
  RunOptions options;
  options.progress = [&](const RunStatus& status) { made.push_back(status.fraction); };
  run_scene(fmt::format(R"(scene: 1
fabric: {{pattern: jersey.yaml, wales: 4, courses: 4, segments_per_stitch: 10}}
effects: {{stretch: , bend: , contact: , knots: , friction: }}
stages: [{{name: relax, duration: 1 s, samples: 1}}]
solver: {{quasi_static: {{tolerance: 1000, first_step: {}}}}}
)",
                        first_step),
            options);
  return made;
}

TEST(QuasiStatic, LeavesNoCrumbToTheEndOfASample) {
  EXPECT_EQ(stops("90 %"), std::vector<double>{1});
  EXPECT_EQ(stops("60 %"), (std::vector<double>{0.5, 1}));
  EXPECT_EQ(stops("40 %"), (std::vector<double>{0.4, 1}));
}

}  // namespace
}  // namespace wale
