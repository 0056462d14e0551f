#include <gtest/gtest.h>

#include <numbers>

#include "sim/effects/beads.hpp"
#include "sim/world.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"

namespace wale {
namespace {

using std::numbers::pi;

constexpr int segments = 8;

struct Pair {
  double force = 0;   ///< on the upper yarn, upwards, N
  double energy = 0;  ///< J
};

/// Two straight yarns, `height` apart; the upper one turned by `angle` and both moved along themselves.
Pair pressed(double height, double angle, double shift_below, double shift_above, double sampling, double l,
             int above_segments = segments) {
  Fabric fabric;
  Material yarn;
  yarn.law = ContactLaw::quadratic;
  fabric.materials = {yarn};
  const double half = segments * l / 2, half_above = above_segments * l / 2;
  const Vec3 along(std::cos(angle), std::sin(angle), 0), up(0, 0, height);
  const auto x = Vec3::UnitX();
  add_yarn(fabric, straight_points((shift_below - half) * x, (shift_below + half) * x, segments), l);
  add_yarn(
      fabric,
      straight_points(up + (shift_above - half_above) * along, up + (shift_above + half_above) * along, above_segments),
      l);
  World world(fabric, {Contact{.sampling = sampling}}, 0.0, at_rest(fabric));
  Pair answer;
  Points force;
  Load load{.energy = &answer.energy, .force = &force};
  world.prepare(at_rest(fabric));
  world.evaluate(at_rest(fabric), load);
  answer.force = force.row(2).tail(above_segments + 3).sum();
  return answer;
}

/// The mean over where the beads happen to lie.
Pair mean_pressed(double height, double angle, double sampling, double l, int above_segments = segments) {
  const int phases = 8;
  const double spacing = l / beads_per_segment(l, Material{}.diameter, sampling);
  Pair mean;
  for (int i = 0; i < phases; ++i)
    for (int j = 0; j < phases; ++j) {
      const Pair one = pressed(height, angle, i * spacing / phases, j * spacing / phases, sampling, l, above_segments);
      mean.force += one.force / (phases * phases);
      mean.energy += one.energy / (phases * phases);
    }
  return mean;
}

const double d = Material{}.diameter, k = Material{}.contact_stiffness;

/// validation.md B30: F = 2π k h (1 - h/d)²/sin θ, V = 2π k d² [1/12 - (x²/2 - 2x³/3 + x⁴/4)]/sin θ, x = h/d.
TEST(CrossingYarns, PressOnEachOtherAsTheClosedFormSays) {
  const OneThread one_thread;
  for (const double angle : {pi / 2, pi / 3})
    for (const double x : {0.9, 0.8, 0.7, 1.0 / 3}) {
      const Pair mean = mean_pressed(x * d, angle, 0.03, 0.6e-3);
      const double force = 2 * pi * k * x * d * std::pow(1 - x, 2) / std::sin(angle);
      const double energy =
          2 * pi * k * d * d * (1.0 / 12 - (x * x / 2 - 2 * x * x * x / 3 + std::pow(x, 4) / 4)) / std::sin(angle);
      EXPECT_NEAR(mean.force, force, 3e-3 * force) << "h/d " << x << " angle " << angle;
      EXPECT_NEAR(mean.energy, energy, 3e-3 * energy) << "h/d " << x << " angle " << angle;
    }
}

/// The largest force two crossing yarns can carry: 0.93084 k d, at h = d/3.
TEST(CrossingYarns, SlipThroughUnderTheQuadraticLawBeyond093KD) {
  const OneThread one_thread;
  EXPECT_NEAR(mean_pressed(d / 3, pi / 2, 0.03, 0.6e-3).force, 0.93084 * k * d, 3e-3 * k * d);
  EXPECT_LT(mean_pressed(0.1 * d, pi / 2, 0.03, 0.6e-3).force, 0.93084 * k * d);
}

/// validation.md B32: with the weight l²/n² and a fixed diameter, neither finer beads nor finer segments stiffen.
TEST(CrossingYarns, PressTheSameHoweverFineTheBeadsAndTheSegments) {
  const OneThread one_thread;
  const double x = 0.8, exact = 2 * pi * k * x * d * std::pow(1 - x, 2);
  for (const double sampling : {0.05, 0.02, 0.01})
    EXPECT_NEAR(mean_pressed(x * d, pi / 2, sampling, 0.6e-3).force, exact, 3e-3 * exact) << sampling;
  for (const double l : {0.45e-3, 0.3e-3})
    EXPECT_NEAR(mean_pressed(x * d, pi / 2, 0.03, l).force, exact, 3e-3 * exact) << l;
}

/// validation.md B31: q = (4kh/d)[asinh(c/h) - c/d] a length, c = √(d² - h²). The ends of a yarn that lies wholly above
/// a longer one see what its middle sees, so force over length is exact.
TEST(ParallelYarns, PressOnEachOtherAsTheClosedFormSays) {
  const OneThread one_thread;
  for (const double x : {0.9, 0.8, 0.6}) {
    const double l = 0.6e-3, h = x * d, c = std::sqrt(d * d - h * h);
    const double exact = 4 * k * x * (std::asinh(c / h) - c / d) * 4 * l;
    EXPECT_NEAR(mean_pressed(h, 0, 0.03, l, 4).force, exact, 1e-2 * exact) << x;
  }
}

}  // namespace
}  // namespace wale
