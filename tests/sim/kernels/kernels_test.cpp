#include "sim/kernels/kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/effects/beads.hpp"
#include "sim/parts.hpp"
#include "tests/support/instruction_sets.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"

namespace wale {
namespace {

/// Layers of parallel yarns across each other, of 1 to 67 segments and three materials: 2, 4 or 11 beads a segment.
Fabric many_lengths(const std::array<ContactLaw, 3>& laws) {
  Fabric fabric;
  for (const ContactLaw law : laws) fabric.materials.push_back({.law = law, .core_diameter = 0.05e-3});
  fabric.materials[1].diameter = 0.13e-3;
  fabric.materials[2].diameter = 0.9e-3;
  const double l = 0.6e-3;
  int yarn = 0;
  for (const int segments : {1, 2, 3, 4, 5, 7, 8, 9, 16, 63, 64, 65, 67}) {
    const double length = l * segments, across = 0.7e-3 * (yarn / 2);
    const Vec3 along = yarn % 2 ? Vec3(length, 0, 0) : Vec3(0, length, 0);
    const Vec3 from = yarn % 2 ? Vec3(0, across, 0.3e-3) : Vec3(across, 0, 0);
    add_yarn(fabric, straight_points(from, from + along, segments), 1.02 * l, yarn % 3);
    ++yarn;
  }
  shake(fabric.points, 0.1 * l, 3);
  // The nearer to the origin, the less do differences of positions round off.
  fabric.points.colwise() -= fabric.points.rowwise().mean();
  return fabric;
}

struct Answer {
  double energy = 0, dissipation = 0, closest = 0;
  Points force;
};

Answer ask(const EffectSpec& spec, const Fabric& fabric, InstructionSet set) {
  const Using use(set);
  const RestSchedules rest = 0.3;
  const State start = shaken_state(fabric, 0, 1);
  State at = shaken_state(fabric, 0.1, 2);
  shake(at.q, 2e-5, 4);
  Parts parts{fabric, rest, start};
  const auto effect = std::visit([&](const auto& of) { return make(of, parts); }, spec);
  Answer answer;
  answer.force = Points::Zero(3, at.q.cols());
  Load load{.energy = &answer.energy, .force = &answer.force, .dissipation = &answer.dissipation};
  effect->prepare(at);
  effect->add(at, load);
  answer.closest = effect->closest();
  return answer;
}

/// Packs against one number at a time, which the compiler may round elsewhere; and packs against each other.
void expect_the_same(const EffectSpec& spec, const Fabric& fabric) {
  const Answer scalar = ask(spec, fabric, InstructionSet::scalar);
  const double size = scalar.force.cwiseAbs().maxCoeff();
  ASSERT_TRUE(size > 0 && std::isfinite(size)) << "the effect is asleep in this state, or beyond it";
  for (const InstructionSet set : packed_sets()) {
    const Answer packed = ask(spec, fabric, set);
    EXPECT_NEAR(packed.energy, scalar.energy, 1e-13 * std::abs(scalar.energy)) << name(set);
    EXPECT_NEAR(packed.dissipation, scalar.dissipation, 1e-13 * scalar.dissipation) << name(set);
    EXPECT_DOUBLE_EQ(packed.closest, scalar.closest) << name(set);
    EXPECT_LT((packed.force - scalar.force).cwiseAbs().maxCoeff(), 1e-13 * size) << name(set);
    const Answer first = ask(spec, fabric, packed_sets().front());
    EXPECT_EQ(packed.energy, first.energy);
    EXPECT_EQ(packed.dissipation, first.dissipation);
    EXPECT_EQ(packed.closest, first.closest);
    EXPECT_TRUE(packed.force == first.force);
  }
}

constexpr std::array<ContactLaw, 3> all_laws{ContactLaw::barrier, ContactLaw::quadratic, ContactLaw::core_shell};

TEST(ForceKernels, GiveTheSameWithEveryInstructionSetAlongYarnsOfAllLengths) {
  const Fabric fabric = many_lengths(all_laws);
  const OneThread one_thread;
  const Tether tether{.segments = {0, 1, 2, 7, 9, 10, 11, 100, 101, 102, 200},
                      .axes = {1, 0, 0.5},
                      .scale = {1.2, 0.9, 1},
                      .move = {3e-4, -1e-4, 2e-4},
                      .progress = 0.4};
  const Obstacle cylinder{.shape = Obstacle::Shape::cylinder, .radius = 12e-3, .stiffness = 200};
  Obstacle plane = cylinder, sphere = cylinder;
  plane.shape = Obstacle::Shape::plane;
  sphere.shape = Obstacle::Shape::sphere;
  for (const EffectSpec& spec :
       std::initializer_list<EffectSpec>{Stretch{}, Stretch{.nodes = 3}, Bend{}, Gravity{}, Drag{},
                                         Plates{.gap = 0.1e-3}, tether, plane, cylinder, sphere})
    expect_the_same(spec, fabric);
}

TEST(ForceKernels, GiveTheSameWithEveryInstructionSetBetweenYarnsOfAllKinds) {
  const OneThread one_thread;
  for (const ContactLaw law : all_laws) expect_the_same(Contact{}, many_lengths({law, law, law}));
  const Fabric fabric = many_lengths(all_laws);
  expect_the_same(Contact{}, fabric);
  expect_the_same(Contact{.sampling = 0.01}, fabric);
  expect_the_same(Contact{.sampling = 0.2, .inflate_beads = true}, fabric);
  expect_the_same(Contact{.screening = 0.5}, fabric);
  expect_the_same(ContactDamping{.tangential = 5, .normal = 40}, fabric);
}

TEST(InstructionSet, IsOneThatThisMachineHas) {
  EXPECT_TRUE(supports(instruction_set()));
  EXPECT_TRUE(supports(InstructionSet::scalar));
}

}  // namespace
}  // namespace wale
