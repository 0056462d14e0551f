#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/one_thread.hpp"
#include "tests/support/run_scene.hpp"

namespace wale {
namespace {

constexpr std::string_view drag = "drag: {coefficient: 0.05 kg/(m s)}";

/// How a stage of a cell goes: by equilibria, or as a motion that is slow.
struct Way {
  std::string_view solver, duration, effects;
};
constexpr Way to_rest{"{quasi_static: {tolerance: 1e-4}}", "1 s", ""};
constexpr Way pulled{"{quasi_static: {tolerance: 0.005}}", "8 s", "friction: {threshold: 0.01 mm/s}"};

constexpr int of_pull = 9;  // samples, the first of them at rest

class AllSolvers : public testing::TestWithParam<const char*> {
 protected:
  Results run(const Way& resting, const Way& pulling) const {
    const OneThread one_thread;
    return run_scene(fmt::format(R"(scene: 1
fabric: {{pattern: {}.yaml, wales: 2, courses: 2, periodic: true, segments_per_stitch: 12}}
effects: {{stretch: , bend: , contact: }}
stages:
  - {{name: tighten, duration: 1 s, tighten: 100 %, samples: 4}}
  - {{name: relax, duration: {}, samples: 1, solver: {}, effects: {{{}}}}}
  - {{name: pull, duration: {}, pull: {{along: wale, to: 40 %}}, samples: 8, solver: {}, effects: {{{}}}}}
)",
                                 GetParam(), resting.duration, resting.solver, resting.effects, pulling.duration,
                                 pulling.solver, pulling.effects));
  }

  static double energy_at_rest(const Results& results) {
    double sum = 0;
    for (const char* of : {"energy.stretch", "energy.bend", "energy.contact"})
      sum += last(results, of, of_pull).front();
    return sum;
  }
};

TEST_P(AllSolvers, FindTheSameCurve) {
  const std::string effects = fmt::format("friction: {{threshold: 4 mm/s}}, {}", drag);
  const std::vector<double> by_equilibria = last(run(to_rest, pulled), "stress", of_pull),
                            by_motion = last(run(to_rest, {"implicit", "20 ms", effects}), "stress", of_pull);
  const double peak = *std::max_element(by_equilibria.begin(), by_equilibria.end());
  for (std::size_t i = 0; i < by_motion.size(); ++i) EXPECT_NEAR(by_motion[i], by_equilibria[i], 0.02 * peak) << i;
}

/// Jersey, rib and seed rest in valleys whose floor is flat: where on it is a matter of chance, how deep is not.
TEST_P(AllSolvers, FindARestOfTheSameEnergy) {
  const double by_equilibria = energy_at_rest(run(to_rest, pulled)),
               by_motion = energy_at_rest(run({"implicit", "20 ms", drag}, pulled));
  EXPECT_NEAR(by_motion, by_equilibria, 0.003 * by_equilibria);
}

INSTANTIATE_TEST_SUITE_P(Structures, AllSolvers, testing::Values("jersey", "garter", "rib_1x1", "seed"));

}  // namespace
}  // namespace wale
