#include <gtest/gtest.h>

#include <numbers>

#include "sim/solver.hpp"
#include "sim/world.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"

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

}  // namespace
}  // namespace wale
