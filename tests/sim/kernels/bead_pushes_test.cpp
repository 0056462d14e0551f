#include "sim/effects/bead_pushes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/effects/contact_law.hpp"
#include "sim/parts.hpp"
#include "sim/world.hpp"
#include "tests/support/cells.hpp"
#include "tests/support/instruction_sets.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"

namespace wale {
namespace {

struct Pushed {
  double energy = 0, closest = 0;
  Points force;
};

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// One bead pair after the other.
void push_pair(const Beads& beads, const SegmentPair& pair, Pushed& pushed) {
  const Fabric& fabric = beads.fabric();
  const auto [a, b, image] = pair;
  const double d = beads.diameter(a, b),
               weight = fabric.segment(a).length * fabric.segment(b).length / (beads.count(a) * beads.count(b));
  for (int i = 0; i < beads.count(a); ++i)
    for (int j = 0; j < beads.count(b); ++j) {
      if (beads.screened(pair, i, j)) continue;
      const Vec3 apart = beads.position(a, i) - beads.position_of_image(pair, j) - beads.displacement(pair);
      const double squared = apart.squaredNorm() / (d * d);
      pushed.closest = std::min(pushed.closest, std::sqrt(squared));
      if (squared >= 1) continue;
      const Penalty f = penalty(fabric.material_of(a), fabric.material_of(b), squared);
      const Vec3 push = -weight * f.slope / (d * d) * apart;
      pushed.energy += weight * f.value;
      for (int k = 0; k < 4; ++k) {
        pushed.force.col(fabric.first_point(a) + k) += beads.basis_of(a, i).value[index(k)] * push;
        pushed.force.col(fabric.first_point(b) + k) -= beads.basis_of(b, j).value[index(k)] * push;
      }
      if (image > 0) pushed.force.rightCols<2>() -= push * beads.images()[index(image)].cast<double>().transpose();
    }
}

Pushed push_one_by_one(const Fabric& fabric, const Contact& spec, const State& at) {
  Beads beads(fabric, spec.sampling, spec.screening, spec.skin);
  beads.prepare(at.q);
  Pushed pushed{.closest = INFINITY, .force = Points::Zero(3, at.q.cols())};
  for (const SegmentPair& pair : beads.pairs()) push_pair(beads, pair, pushed);
  return pushed;
}

Pushed push_by_kernels(const Fabric& fabric, const Contact& spec, const State& at) {
  const RestSchedules rest;
  Parts parts{fabric, rest, at};
  const auto effect = make(spec, parts);
  Pushed pushed{.force = Points::Zero(3, at.q.cols())};
  Load load{.energy = &pushed.energy, .force = &pushed.force};
  State before = at;
  before.q *= 1.5;
  effect->prepare(before);  // so that all is found again
  effect->prepare(at);
  effect->add(at, load);
  pushed.closest = effect->closest();
  return pushed;
}

void expect_pushes_of_all_bead_pairs(const Fabric& fabric, const Contact& spec, const State& at) {
  const Pushed expected = push_one_by_one(fabric, spec, at);
  const double size = expected.force.cwiseAbs().maxCoeff();
  ASSERT_TRUE(size > 0 && std::isfinite(size));
  std::vector<InstructionSet> sets = packed_sets();
  sets.push_back(InstructionSet::scalar);
  for (const InstructionSet set : sets) {
    const Using use(set);
    const Pushed pushed = push_by_kernels(fabric, spec, at);
    EXPECT_NEAR(pushed.energy, expected.energy, 1e-12 * expected.energy) << name(set);
    EXPECT_NEAR(pushed.closest, expected.closest, 1e-12 * expected.closest) << name(set);
    EXPECT_LT((pushed.force - expected.force).cwiseAbs().maxCoeff(), 1e-12 * size) << name(set);
  }
}

/// The spacing α of beads of which a segment has so many, see beads_per_segment().
double sampling_for(int beads, const Fabric& fabric) {
  const double apart = fabric.segments.front().length / fabric.materials.front().diameter / (beads - 0.5);
  return (std::sqrt(1 + apart * apart * 2 / 3) - 1) / 2;
}

class NumbersOfBeads : public testing::TestWithParam<int> {};

TEST_P(NumbersOfBeads, AreAllPushedOnceOffAllOthers) {
  const OneThread one_thread;
  const Fabric fabric = woven_yarns(8, 8, 1);
  const double sampling = sampling_for(GetParam(), fabric);
  ASSERT_EQ(Beads(fabric, sampling, 0, 0.1).count(0), GetParam());
  const State at = shaken_state(fabric, 0, 1);
  expect_pushes_of_all_bead_pairs(fabric, {.sampling = sampling}, at);
  expect_pushes_of_all_bead_pairs(fabric, {.sampling = sampling, .screening = 0.6}, at);
}

TEST_P(NumbersOfBeads, MayDifferBetweenMaterials) {
  const OneThread one_thread;
  Fabric fabric = woven_yarns(8, 8, 2);
  fabric.materials.push_back({.diameter = 0.31e-3, .law = ContactLaw::quadratic});
  fabric.materials.push_back({.diameter = 0.7e-3});
  for (Segment& segment : fabric.segments) segment.material = segment.yarn % 3;
  const State at = shaken_state(fabric, 0, 1);
  expect_pushes_of_all_bead_pairs(fabric, {.sampling = sampling_for(GetParam(), fabric)}, at);
}

TEST_P(NumbersOfBeads, AreAllPushedOffImagesToo) {
  const OneThread one_thread;
  const Fabric fabric = compile_repeat({"kp", "pk"}, 8).fabric;
  State at = at_rest(fabric);
  at.q *= 0.8;
  expect_pushes_of_all_bead_pairs(fabric, {.sampling = sampling_for(GetParam(), fabric)}, at);
}

INSTANTIATE_TEST_SUITE_P(BeadPushes, NumbersOfBeads, testing::Values(1, 2, 3, 4, 5, 7, 8));

/// Parallel yarns, each of which touches the next one.
Fabric parallel_yarns(int count, int segments) {
  Fabric fabric;
  fabric.materials = {Material{}};
  const double l = 0.6e-3, apart = 0.45e-3;
  for (int i = 0; i < count; ++i)
    add_yarn(fabric, straight_points({0, apart * i, 0}, {l * segments, apart * i, 0}, segments), l);
  shake(fabric.points, 0.05 * l, 4);
  return fabric;
}

/// Those that segments of a range are paired with lie within its reach, or also beyond.
TEST(BeadPushes, CrossFromRangeToRange) {
  for (const bool beyond : {false, true}) {
    const Fabric fabric = beyond ? woven_yarns(30, 30, 3) : parallel_yarns(40, 30);
    Beads beads(fabric, 0.03, 1.6, 0.1);
    beads.prepare(fabric.points);
    ASSERT_GT(beads.boundaries().size(), 4u);
    EXPECT_GT(beads.reaches()[0], beads.boundaries()[1]);
    EXPECT_EQ(beads.leaves(0), beyond);
    expect_pushes_of_all_bead_pairs(fabric, {}, shaken_state(fabric, 0, 1));
  }
}

TEST(BeadPushes, HaveTheSameBitsOnAnyNumberOfThreads) {
  const Fabric fabric = woven_yarns(30, 30, 3);
  const State at = shaken_state(fabric, 0, 1);
  const OneThread one_thread;
  const Pushed by_one = push_by_kernels(fabric, {}, at);
  omp_set_num_threads(3);
  const Pushed by_many = push_by_kernels(fabric, {}, at);
  EXPECT_EQ(by_one.energy, by_many.energy);
  EXPECT_EQ(by_one.closest, by_many.closest);
  EXPECT_TRUE(by_one.force == by_many.force);
}

}  // namespace
}  // namespace wale
