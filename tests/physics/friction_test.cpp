#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "sim/solver.hpp"
#include "sim/world.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"
#include "tests/support/run_scene.hpp"

namespace wale {
namespace {

using std::numbers::pi;

/// A thin yarn over half a turn of a thick one that stands still: one end is hauled in, a weak spring holds the other.
struct Capstan {
  OneThread one_thread;
  Fabric fabric;
  int thin_segments = 0;

  explicit Capstan(double angle) {
    Material thick, thin;
    thick.diameter = 3e-3;
    thin.diameter = 0.15e-3;
    thin.bending_rigidity = 1e-12;
    thin.axial_stiffness = 20;
    fabric.materials = {thick, thin};
    add_yarn(fabric, straight_points({0, 0, -0.8e-3}, {0, 0, 0.8e-3}, 4), 0.4e-3);
    const double radius = 0.985 * (thick.diameter + thin.diameter) / 2, l = 0.2e-3, straight = 3e-3;
    const double length = radius * angle + 2 * straight;
    thin_segments = static_cast<int>(std::lround(length / l));
    Points points(3, thin_segments + 3);
    for (int k = 0; k < thin_segments + 3; ++k) {
      const double s = (k - 1.0) / thin_segments * length - straight;  // along the yarn, from where it meets the other
      const double at = std::clamp(s / radius, 0.0, angle), beyond = s - radius * at;
      points.col(k) =
          Vec3(radius * std::cos(at) - beyond * std::sin(at), radius * std::sin(at) + beyond * std::cos(at), 0);
    }
    add_yarn(fabric, points, length / thin_segments, 1);
  }
};

struct Tensions {
  double slack = 0, tight = 0;  // N
};

/// Hauls the yarn over the other, in steps of a share `step` of the whole pull, until it slides all along.
Tensions slide(double angle, double friction, double step) {
  const Capstan capstan(angle);
  const Fabric& fabric = capstan.fabric;
  const int first = 4, last = fabric.segment_count() - 1;
  const Vec3 haul(-std::sin(angle), std::cos(angle), 0), back(0, -1, 0);
  const double weak = 2e3, l0 = fabric.segment(first).length, spring = 2 * weak * l0;  // N/m
  const double tension = 5e-3, before = tension / spring, way = 0.6e-3;
  const Schedule in({{0, 0}, {0.5, 0}, {1, 1}}), out({{0, 0}, {0.5, 1}});
  std::vector<int> thick{0, 1, 2, 3};
  const std::vector<EffectSpec> effects{
      Stretch{},
      Bend{},
      Contact{.sampling = 0.002},
      Friction{.coefficient = friction, .threshold = 2e-5, .sampling = 0.002},
      Tether{.label = "thick", .segments = thick, .stiffness = 1e9},
      Tether{.label = "slack", .segments = {first}, .stiffness = weak, .move = before * back, .progress = out},
      Tether{.label = "tight", .segments = {last}, .stiffness = 1e6, .move = way * haul, .progress = in}};
  World world(fabric, effects, 0.0, at_rest(fabric), {}, true);
  const auto solver =
      make(QuasiStatic{.tolerance = 2e-2, .iterations = 1000, .first_step = step, .smallest_step = 1e-6}, world,
           at_rest(fabric));
  State now = at_rest(fabric);
  while (now.t < 1) {
    if (solver->advance(std::min(1.0, now.t + step)) == Progress::failed)
      throw std::runtime_error(solver->effort().failure);
    now = solver->state();
  }
  Tensions found;
  for (const auto& effect : world.effects()) {
    Points force = Points::Zero(3, now.q.cols());
    Load load{.force = &force};
    effect->prepare(now);
    effect->add(now, load);
    const Vec3 sum = force.rowwise().sum();
    if (effect->name() == "slack") found.slack = sum.dot(back);
    if (effect->name() == "tight") found.tight = sum.dot(haul);
  }
  return found;
}

/// Euler and Eytelwein: T2/T1 = exp(µ φ).
TEST(Friction, MultipliesTensionByTheCapstanEquation) {
  for (const double angle : {pi, 2 * pi / 3})
    for (const double friction : {0.1, 0.3})
      for (const double step : {0.025, 0.0125}) {
        const Tensions found = slide(angle, friction, step);
        EXPECT_NEAR(found.tight / found.slack / std::exp(friction * angle), 1, 0.02)
            << "angle " << angle << " friction " << friction << " step " << step;
      }
}

/// How far a short yarn across two rails slides down in a millisecond, m, when these lean by `lean`. Its weight is
/// multiplied until it presses deep enough that no bead is felt.
constexpr double heavy = 2e4, fall = 1e-3, slow = 1e-2;  // m/s², s, m/s
double slide_down(double lean, double friction) {
  const OneThread one_thread;
  Fabric fabric;
  fabric.materials = {Material{}};
  const double d = Material{}.diameter, l = 0.5e-3;
  for (const double side : {-0.75e-3, 0.75e-3})
    add_yarn(fabric, straight_points({-1.5e-3, side, 0}, {1.5e-3, side, 0}, 6), l);
  add_yarn(fabric, straight_points({0, -1.5e-3, 0.97 * d}, {0, 1.5e-3, 0.97 * d}, 6), l);
  const std::vector<int> rails{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  const auto leaning_by = [&](double angle) {
    return std::vector<EffectSpec>{Stretch{},
                                   Bend{},
                                   Contact{.sampling = 0.002},
                                   ContactDamping{.normal = 2e4, .sampling = 0.002},
                                   Friction{.coefficient = friction, .threshold = slow, .sampling = 0.002},
                                   Gravity{heavy * Vec3(std::sin(angle), 0, -std::cos(angle))},
                                   Tether{.segments = rails, .stiffness = 1e9}};
  };
  State now = at_rest(fabric);
  for (const double angle : {0.0, lean}) {
    World world(fabric, leaning_by(angle), 0.0, at_rest(fabric), {}, true);
    now.t = 0;
    now.step = 0;
    const auto solver = make(Implicit{.absolute_speed = slow / 10}, world, now);
    while (solver->advance(fall) == Progress::stepped) continue;
    if (solver->state().t < fall) throw std::runtime_error(solver->effort().failure);
    const double before = now.q.row(0).tail(9).mean();
    now = solver->state();
    if (angle > 0) return now.q.row(0).tail(9).mean() - before;
  }
  return 0;
}

TEST(Friction, HoldsAYarnBelowTheAngleOfFrictionAndLetsItSlideAboveIt) {
  for (const double friction : {0.1, 0.3}) {
    const double angle = std::atan(friction), steep = 1.1 * angle;
    EXPECT_LT(slide_down(0.9 * angle, friction), slow * fall);
    const double pull = heavy * (std::sin(steep) - friction * std::cos(steep));
    EXPECT_NEAR(slide_down(steep, friction), pull * fall * fall / 2, 0.05 * pull * fall * fall / 2 + slow * fall);
  }
}

/// The work of three loops between the strains 30 % and 0 %, and what of it is lost, J/m³.
struct Loops {
  double lost[3] = {}, stored = 0;
};

Loops pull_to_and_fro(const std::string& friction) {
  const OneThread one_thread;
  const Results results = run_scene(R"(scene: 1
fabric: {pattern: jersey.yaml, wales: 1, courses: 1, periodic: true}
effects: {stretch: , bend: , contact: , friction: {coefficient: )" +
                                    friction + R"(, threshold: 1e-6 m/s}}
stages:
  - {name: tighten, duration: 1 s, tighten: 100 %, samples: 4}
  - {name: relax, duration: 1 s, samples: 2}
  - {name: cycle, duration: 50 s, pull: {along: wale, to: [30 %, 0 %, 30 %, 0 %, 30 %, 0 %]}, samples: 60}
solver: {quasi_static: {tolerance: 0.005}}
)");
  const std::vector<double> strain = last(results, "strain", 61), stress = last(results, "stress", 61);
  Loops loops;
  for (std::size_t k = 0; k < 60; ++k) {
    const double work = (stress[k] + stress[k + 1]) / 2 * (strain[k + 1] - strain[k]);
    loops.lost[k / 20] += work;
    if (k < 10) loops.stored += work;
  }
  return loops;
}

/// As fabrics do: the first loop loses more than the next, and these lie on each other.
TEST(Friction, MakesAFabricLoseWorkInLoopsThatClose) {
  const Loops with = pull_to_and_fro("0.3"), without = pull_to_and_fro("0");
  EXPECT_GT(with.lost[1], 0.3 * with.stored);
  EXPECT_GT(with.lost[0], 1.02 * with.lost[1]);
  EXPECT_NEAR(with.lost[2], with.lost[1], 1e-3 * with.lost[1]);
  for (const double lost : without.lost) EXPECT_LT(std::abs(lost), 5e-3 * without.stored);
}

/// The stress at each sample of a pull of jersey that has come to rest without friction, Pa.
std::vector<double> pull_from_rest(const std::string& along, int samples, const std::string& to = "80 %") {
  const OneThread one_thread;
  const Results results = run_scene(fmt::format(R"(scene: 1
fabric: {{pattern: jersey.yaml, wales: 2, courses: 2, periodic: true, segments_per_stitch: 12}}
effects: {{stretch: , bend: , contact: }}
stages:
  - {{name: tighten, duration: 1 s, tighten: 100 %, samples: 4}}
  - {{name: relax, duration: 1 s, samples: 1, solver: {{quasi_static: {{tolerance: 1e-4}}}}}}
  - {{name: pull, duration: 1 s, pull: {{along: {}, to: {}}}, samples: {}, effects: {{friction: }}}}
solver: {{quasi_static: {{tolerance: 0.002}}}}
)",
                                                along, to, samples));
  return last(results, "stress", samples + 1);
}

/// Normal forces taken from where a step begins would be off by the first order of the step.
TEST(Friction, IsOfSecondOrderInTheLoadStep) {
  for (const char* along : {"wale", "course"}) {
    const int coarse = 12, finer = 8;
    const std::vector<double> stress = pull_from_rest(along, coarse), fine = pull_from_rest(along, finer * coarse);
    const double peak = *std::max_element(fine.begin(), fine.end());
    for (int i = 0; i <= coarse; ++i)
      EXPECT_NEAR(stress[static_cast<std::size_t>(i)], fine[static_cast<std::size_t>(finer * i)], 0.01 * peak)
          << along << " " << i;
  }
}

/// The turn lies between two of five samples: a pull that went past it would miss the largest load.
TEST(Friction, RemembersATurnThatNoSampleFallsOn) {
  const std::vector<double> across = pull_from_rest("course", 5, "[40 %, 20 %]"),
                            on = pull_from_rest("course", 15, "[40 %, 20 %]");
  const double peak = *std::max_element(on.begin(), on.end());
  for (std::size_t i = 0; i <= 5; ++i) EXPECT_NEAR(across[i], on[3 * i], 0.02 * peak) << i;
}

}  // namespace
}  // namespace wale
