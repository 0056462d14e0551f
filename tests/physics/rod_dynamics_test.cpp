#include <gtest/gtest.h>

#include <numbers>

#include "sim/solver.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/modes.hpp"
#include "tests/support/one_thread.hpp"

namespace wale {
namespace {

using std::numbers::pi;

double wave_speed(const Material& yarn) { return std::sqrt(yarn.axial_stiffness / yarn.linear_density); }

/// Without bending, no motion sideways costs anything, nor does drifting: the axial modes are the highest.
TEST(Rod, CarriesAxialWavesAtTheSpeedOfSound) {
  const double L = 0.02;
  const int segments = 8;
  const Fabric fabric = straight_rod(L, segments);
  World world(fabric, {Stretch{.nodes = 3}}, 0.0, at_rest(fabric));
  const Eigen::VectorXd squares = squared_frequencies(world, at_rest(fabric));
  const Eigen::VectorXd axial = squares.tail(segments + 2).cwiseSqrt();
  const double first = pi * wave_speed(fabric.materials[0]) / L;
  // validation/spline_mode_frequency_error.csv, N = 8: 5.286e-8 and 4.21e-6.
  EXPECT_NEAR(axial[0] / first - 1, 5.286e-8, 5e-9);
  EXPECT_NEAR(axial[1] / (2 * first) - 1, 4.21e-6, 1e-7);
}

/// validation.md B24.
TEST(Rod, HasTheFastestAxialModeThatBoundsTheTimeStep) {
  for (const int segments : {16, 32}) {  // in a shorter rod the modes of both ends know of each other
    const double l = 0.6e-3;
    const Fabric fabric = straight_rod(l * segments, segments);
    World world(fabric, {Stretch{.nodes = 3}}, 0.0, at_rest(fabric));
    const double fastest = std::sqrt(squared_frequencies(world, at_rest(fabric)).maxCoeff());
    EXPECT_NEAR(fastest, 6.8706 * wave_speed(fabric.materials[0]) / l, 1e-4 * fastest);
  }
}

/// βL by validation/beam_frequencies_betaL.csv, ω = (βL)² √(EI/rho)/L².
TEST(Rod, VibratesSidewaysAtTheFrequenciesOfABeam) {
  struct Beam {
    std::string name;
    std::vector<Clamp> clamps;
    int rigid;  ///< motions without energy
    std::array<double, 2> beta_l;
  };
  const Clamp held{.yarn = 0, .direction = true}, pinned{.yarn = 0};
  Clamp held_end = held, pinned_end = pinned;
  held_end.at_end = pinned_end.at_end = true;
  const double L = 0.02;
  const Fabric fabric = straight_rod(L, 16);
  const Material& yarn = fabric.materials[0];
  const double scale = std::sqrt(yarn.bending_rigidity / yarn.linear_density) / (L * L);
  for (const Beam& beam : {Beam{"clamped-free", {held}, 0, {1.875104069, 4.694091133}},
                           Beam{"free-free", {}, 5, {4.730040745, 7.853204624}},
                           Beam{"clamped-clamped", {held, held_end}, 0, {4.730040745, 7.853204624}},
                           Beam{"pinned-pinned", {pinned, pinned_end}, 0, {3.141592654, 6.283185307}},
                           Beam{"clamped-pinned", {held, pinned_end}, 0, {3.926602312, 7.068582746}}}) {
    World world(fabric, {Stretch{.nodes = 3}, Bend{}}, 0.0, at_rest(fabric), beam.clamps);
    const Eigen::VectorXd squares = squared_frequencies(world, at_rest(fabric));
    for (int mode = 0; mode < 2; ++mode) {
      const double expected = std::pow(beam.beta_l[static_cast<std::size_t>(mode)], 2) * scale;
      for (int plane = 0; plane < 2; ++plane)  // every mode stands in two planes
        EXPECT_NEAR(std::sqrt(squares[beam.rigid + 2 * mode + plane]), expected, 1e-4 * expected) << beam.name;
    }
  }
}

/// model.md item 9: a free yarn slows as exp(-2 k_g t/rho), whatever its segments.
TEST(Drag, SlowsAFreeYarnByOneExponential) {
  const OneThread one_thread;
  for (const int segments : {3, 10}) {
    const Fabric fabric = straight_rod(0.01, segments);
    const Drag drag{.coefficient = 0.05};
    World world(fabric, {drag}, 0.0, at_rest(fabric));
    State start = at_rest(fabric);
    start.v.colwise() = Vec3(0.3, -0.2, 0.1);
    const auto solver = make(RungeKutta{.relative = 1e-9, .absolute = 1e-14}, world, start);
    const double rate = 2 * drag.coefficient / fabric.materials[0].linear_density, until = 3 / rate;
    while (solver->advance(until) == Progress::stepped) {
      const double left = std::exp(-rate * solver->state().t);
      EXPECT_LT((solver->state().v - left * start.v).norm(), 1e-6 * left * start.v.norm());
    }
    EXPECT_EQ(solver->state().t, until);
  }
}

/// Two soft yarns laid across each other too close: they push off, bend and ring.
struct Collision {
  OneThread one_thread;
  Fabric fabric;
  std::unique_ptr<World> world;
  State start;

  explicit Collision(const std::vector<EffectSpec>& more = {}, bool lagged = false) {
    Material soft;
    soft.axial_stiffness = 0.1;
    soft.contact_stiffness = 2;
    fabric.materials = {soft};
    const double half = 1.5e-3;
    add_yarn(fabric, straight_points({-half, 1e-4, 0}, {half, 1e-4, 0}, 5), 2 * half / 5);
    add_yarn(fabric, straight_points({2e-4, -half, 0.4e-3}, {0, half, 0.4e-3}, 5), 2 * half / 5);
    std::vector<EffectSpec> effects{Stretch{}, Bend{}, Contact{}};
    effects.insert(effects.end(), more.begin(), more.end());
    start = at_rest(fabric);
    shake(start.q, 1e-5, 2);
    shake(start.v, 0.05, 3);
    start.v.rightCols(8).row(2).array() -= 0.2;
    world = std::make_unique<World>(fabric, effects, 0.0, start, std::vector<Clamp>{}, lagged);
  }

  double energy(const State& at) const {
    double potential = 0;
    Load load{.energy = &potential};
    world->prepare(at);
    world->evaluate(at, load);
    return potential + world->mass().kinetic_energy(at.v);
  }
  double power_lost(const State& at) const {
    double dissipation = 0;
    Load load{.dissipation = &dissipation};
    world->prepare(at);
    world->evaluate(at, load);
    return 2 * dissipation;
  }
  Vec3 momentum(const State& at) const { return world->mass().times(at.v).rowwise().sum(); }
  /// About the origin: Σ q × M v.
  Vec3 angular_momentum(const State& at) const {
    const Points p = world->mass().times(at.v);
    Vec3 sum = Vec3::Zero();
    for (Eigen::Index i = 0; i < p.cols(); ++i) sum += at.q.col(i).cross(p.col(i));
    return sum;
  }
  /// Of the slowest bending mode of a free yarn, s.
  double period() const {
    const Material& yarn = fabric.materials[0];
    return 2 * pi / (std::pow(4.730040745 / 3e-3, 2) * std::sqrt(yarn.bending_rigidity / yarn.linear_density));
  }
};

/// validation.md B22.
TEST(FreeYarns, KeepMomentumAndEnergyThroughACollision) {
  Collision collision;
  const auto solver = make(RungeKutta{.relative = 1e-8, .absolute = 1e-13}, *collision.world, collision.start);
  const State& now = solver->state();
  const double energy = collision.energy(now);
  const Vec3 momentum = collision.momentum(now), angular = collision.angular_momentum(now);
  ASSERT_LT(collision.world->closest(), 0.9);
  double drift = 0;
  for (int i = 1; i <= 10; ++i) {
    while (solver->advance(i * collision.period()) == Progress::stepped) continue;
    ASSERT_EQ(now.t, i * collision.period()) << solver->effort().failure;
    drift = std::max(drift, std::abs(collision.energy(now) - energy));
    EXPECT_LT((collision.momentum(now) - momentum).norm(), 1e-12 * momentum.norm());
    EXPECT_LT((collision.angular_momentum(now) - angular).norm(), 1e-6 * angular.norm());
  }
  EXPECT_LT(drift, 1e-6 * energy);
  EXPECT_GT((now.v - collision.start.v).norm(), 0.3 * collision.start.v.norm());
}

/// What is lost is the integral of 2 D over time, by Simpson's rule on the dense output of every step.
TEST(FreeYarns, LoseAsMuchEnergyAsDragAndContactDissipate) {
  Collision collision({Drag{.coefficient = 0.01}, ContactDamping{.tangential = 10, .normal = 100}});
  const auto solver = make(RungeKutta{.relative = 1e-8, .absolute = 1e-13}, *collision.world, collision.start);
  const double energy = collision.energy(solver->state());
  double lost = 0;
  Progress progress = Progress::stepped;
  while (progress == Progress::stepped) {
    const State before = solver->state();
    progress = solver->advance(collision.period());
    const State &after = solver->state(), middle = solver->at((before.t + after.t) / 2);
    lost += (after.t - before.t) / 6 *
            (collision.power_lost(before) + 4 * collision.power_lost(middle) + collision.power_lost(after));
  }
  ASSERT_EQ(progress, Progress::arrived);
  EXPECT_GT(lost, 0.05 * energy);
  EXPECT_NEAR(energy - collision.energy(solver->state()), lost, 1e-5 * lost);
}

constexpr Implicit fine{.relative = 1e-5, .absolute = 1e-10, .absolute_speed = 1e-7};

/// To rounding, which adds up over the steps.
TEST(FreeYarns, KeepMomentumThroughAnImplicitCollision) {
  Collision collision({}, true);
  const auto solver = make(Implicit{}, *collision.world, collision.start);
  const State& now = solver->state();
  const Vec3 momentum = collision.momentum(now);
  const double carried = collision.world->mass().times(now.v).colwise().norm().sum();
  while (solver->advance(3 * collision.period()) == Progress::stepped)
    EXPECT_LT((collision.momentum(now) - momentum).norm(), 2e-10 * carried);
  ASSERT_EQ(now.t, 3 * collision.period()) << solver->effort().failure;
  EXPECT_GT((now.v - collision.start.v).norm(), 0.3 * collision.start.v.norm());
}

TEST(FreeYarns, GainNoEnergyInADampedImplicitCollision) {
  Collision collision({Drag{.coefficient = 1e-3}, ContactDamping{.tangential = 10, .normal = 100},
                       Friction{.coefficient = 0.3}},
                      true);
  const auto solver = make(Implicit{.relative = 1e-4}, *collision.world, collision.start);
  double before = collision.energy(solver->state());
  const double start = before;
  while (solver->advance(3 * collision.period()) == Progress::stepped) {
    const double energy = collision.energy(solver->state());
    EXPECT_LT(energy - before, 1e-4 * start);
    before = energy;
  }
  ASSERT_EQ(solver->state().t, 3 * collision.period()) << solver->effort().failure;
  EXPECT_LT(before, 0.9 * start);
}

TEST(Drag, SlowsAFreeYarnByOneExponentialImplicitly) {
  const OneThread one_thread;
  const Fabric fabric = straight_rod(0.01, 3);
  const Drag drag{.coefficient = 0.05};
  World world(fabric, {drag, Stretch{}, Bend{}}, 0.0, at_rest(fabric), {}, true);
  State start = at_rest(fabric);
  start.v.colwise() = Vec3(0.3, -0.2, 0.1);
  const double rate = 2 * drag.coefficient / fabric.materials[0].linear_density;
  for (const Implicit& spec : {Implicit{.absolute_speed = 1e-8}, fine}) {
    const auto solver = make(spec, world, start);
    while (solver->advance(3 / rate) == Progress::stepped) continue;
    const double left = std::exp(-3.0);
    EXPECT_LT((solver->state().v - left * start.v).norm(), 2 * spec.relative * start.v.norm());
  }
}

/// A yarn is bent by a pull at its middle and let go: explicit and implicit steps lead to the same place.
TEST(Release, IsTheSameByExplicitAndImplicitSteps) {
  const OneThread one_thread;
  const Fabric fabric = straight_rod(14.4e-3, 24);
  const Schedule pull = Schedule::ramp(0, 1, 1);
  World bent(fabric,
             {Stretch{}, Bend{}, Tether{.label = "ends", .segments = {0, 23}, .axes = {0, 1, 1}},
              Tether{.label = "middle", .segments = {10, 11, 12, 13}, .move = {0, 2e-3, 0}, .progress = pull}},
             0.0, at_rest(fabric));
  const auto equilibria = make(QuasiStatic{.tolerance = 1e-5, .first_step = 0.1}, bent, at_rest(fabric));
  while (equilibria->advance(1) == Progress::stepped) continue;
  State start = at_rest(fabric);
  start.q = equilibria->state().q;

  const std::vector<EffectSpec> effects{Stretch{}, Bend{}, Contact{}, Drag{}};
  const double until = 5e-3;
  World lagged(fabric, effects, 0.0, start, {}, true), plain(fabric, effects, 0.0, start);
  const auto implicit = make(Implicit{.relative = 0.1}, lagged, start);
  const auto explicitly = make(RungeKutta{}, plain, start);
  while (implicit->advance(until) == Progress::stepped) continue;
  while (explicitly->advance(until) == Progress::stepped) continue;
  const double way = (explicitly->state().q - start.q).norm();
  const double apart = (explicitly->state().q - implicit->state().q).norm() / way;
  EXPECT_LT(apart, 0.03);
  EXPECT_LT(50 * implicit->effort().evaluations, explicitly->effort().evaluations);
}

}  // namespace
}  // namespace wale
