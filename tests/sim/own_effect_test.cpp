#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "examples/08_own_effect/spin.hpp"
#include "sim/world.hpp"
#include "tests/support/finite_difference.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"
#include "tests/support/solver_runs.hpp"

namespace wale {
namespace {

std::string read(const std::string& path) {
  std::ifstream file(WALE_SOURCE_DIR "/" + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Spin, IsTheOneThatThePageShows) {
  const std::string source = read("examples/08_own_effect/spin.hpp"), page = read("docs/add_an_effect.md");
  ASSERT_FALSE(source.empty());
  EXPECT_NE(page.find("```cpp\n" + source + "```\n"), std::string::npos);
}

TEST(Spin, HasAForceThatIsTheSlopeOfItsEnergyAndAStiffnessThatIsTheSlopeOfItsForce) {
  const Fabric fabric = crossing_yarns(ContactLaw::barrier, 11);
  const Spin spin(fabric, 300, Vec3(0.6, 0, 0.8));
  State at = at_rest(fabric);
  const auto energy = [&](const Points& q) {
    State there = at;
    there.q = q;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(1);
    Load load{.energy = sum.data()};
    spin.add(there, load);
    return sum;
  };
  const auto force = [&](const Points& q) {
    State there = at;
    there.q = q;
    Points sum = Points::Zero(3, q.cols());
    Load load{.force = &sum};
    spin.add(there, load);
    return sum.reshaped().eval();
  };
  Stiffness stiffness(static_cast<int>(at.q.cols()));
  Load load{.stiffness = &stiffness};
  spin.add(at, load);
  const Eigen::VectorXd slope = -slope_of(energy, at.q, 1e-6).transpose();
  EXPECT_LT((force(at.q) - slope).norm(), 1e-6 * slope.norm());
  const Eigen::MatrixXd second = -slope_of(force, at.q, 1e-6);
  EXPECT_LT((dense(stiffness) - second).norm(), 1e-6 * second.norm());
}

/// T(r) = ½ ρ ω² (L² - r²) where the yarn hardly stretches.
TEST(Spin, PullsAYarnThatIsHeldAtTheAxisByTheMassBeyond) {
  const OneThread one_thread;
  const double L = 20e-3, speed = 2000;
  const int segments = 32;
  const Fabric fabric = straight_rod(L, segments);
  const Material& yarn = fabric.materials[0];
  World world(fabric, {Stretch{.nodes = 3}, Bend{}}, 0.0, at_rest(fabric), {{.yarn = 0, .direction = true}});
  world.add(std::make_unique<Spin>(fabric, speed, Vec3::UnitZ()));
  const auto solver = make(QuasiStatic{.tolerance = 1e-5}, world, at_rest(fabric));
  const State spun = run_to(*solver, 1);
  const double most = yarn.linear_density * speed * speed * L * L / 2;
  for (int i = 0; i < segments; ++i) {
    const double r = (i + 0.5) * L / segments;
    const double strain = combine(spun.q, i, basis(0.5).first).norm() / (L / segments) - 1;
    EXPECT_NEAR(yarn.axial_stiffness * strain / most, 1 - r * r / (L * L), 5e-3) << i;
  }
}

}  // namespace
}  // namespace wale
