#include <gtest/gtest.h>

#include "sim/solver.hpp"
#include "sim/spline.hpp"
#include "sim/world.hpp"
#include "tests/support/convergence.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"

namespace wale {
namespace {

constexpr double L = 0.02;  // m

/// Thick, because the solver moves no point further than a share of the diameter at once; but a share of a segment.
Material thick_yarn() {
  Material yarn;
  yarn.diameter = L / 20;
  return yarn;
}

/// A constant force, grown with time, on the far end of the first yarn.
class EndLoad final : public Effect {
 public:
  EndLoad(const Fabric& fabric, const Vec3& load) : first_(fabric.yarns[0].segments - 1), load_(load) {}
  std::string_view name() const override { return "end_load"; }
  void add(const State& at, Load& out) const override {
    const Basis end = basis(1);
    if (out.energy) *out.energy -= at.t * load_.dot(combine(at.q, first_, end.value));
    if (out.force)
      for (int k = 0; k < 4; ++k) out.force->col(first_ + k) += at.t * end.value[static_cast<std::size_t>(k)] * load_;
  }

 private:
  int first_;
  Vec3 load_;
};

struct Tip {
  double reach = 0, drop = 0;  ///< over L
  long rejected = 0;
};

/// A rod held level at its start, under `load` N at its end and `weight` N/m along it, both downwards.
Tip cantilever(int segments, double load, double weight, int stretch_nodes, int iterations = 1000) {
  const OneThread one_thread;
  const Fabric fabric = straight_rod(L, segments, thick_yarn());
  const double g = weight / fabric.materials[0].linear_density;
  World world(fabric, {Stretch{stretch_nodes}, Bend{}, Gravity{{0, 0, -g}}}, 0.0, at_rest(fabric),
              {{.yarn = 0, .direction = true}});
  world.add(std::make_unique<EndLoad>(fabric, Vec3(0, 0, -load)));
  const auto solver = make(QuasiStatic{.tolerance = 1e-7, .iterations = iterations}, world, at_rest(fabric));
  while (solver->advance(1) == Progress::stepped) continue;
  EXPECT_EQ(solver->state().t, 1) << solver->effort().failure;
  const Vec3 end = combine(solver->state().q, segments - 1, basis(1).value);
  return {end.x() / L, -end.z() / L, solver->effort().rejected};
}

double worst(const Tip& tip, double reach, double drop) {
  return std::max(std::abs(tip.reach / reach - 1), std::abs(tip.drop / drop - 1));
}

/// validation/cantilever_tip_load.csv: P L²/EI, reach and drop of the end over L.
constexpr double tip_load[][3] = {
    {1, 0.94356676, 0.30172077}, {5, 0.61237164, 0.71379152}, {10, 0.4450044, 0.81060902}};
/// validation/cantilever_self_weight.csv: q L³/EI, reach and drop of the end over L.
constexpr double self_weight[][3] = {
    {1, 0.9912464, 0.1234714}, {5, 0.84665718, 0.49590504}, {10, 0.65635376, 0.70019971}, {50, 0.24501476, 0.90791712}};

double tip_load_error(int segments, const double (&row)[3], int nodes) {
  const double load = row[0] * thick_yarn().bending_rigidity / (L * L);
  return worst(cantilever(segments, load, 0, nodes), row[1], row[2]);
}

double self_weight_error(int segments, const double (&row)[3], int nodes) {
  const double weight = row[0] * thick_yarn().bending_rigidity / (L * L * L);
  return worst(cantilever(segments, 0, weight, nodes), row[1], row[2]);
}

TEST(Cantilever, TakesTheShapeOfTheElasticaUnderAnEndLoad) {
  for (const auto& row : tip_load)
    for (const int nodes : {1, 3}) EXPECT_LT(tip_load_error(32, row, nodes), 5e-3) << row[0] << " nodes " << nodes;
}

TEST(Cantilever, TakesTheShapeOfTheHeavyElasticaUnderItsOwnWeight) {
  for (const auto& row : self_weight)
    for (const int nodes : {1, 3}) EXPECT_LT(self_weight_error(32, row, nodes), 5e-3) << row[0] << " nodes " << nodes;
}

/// The yarn is not quite inextensible: below 1e-5 the table no longer holds, so one node is tested on coarser rods.
TEST(Cantilever, ConvergesToTheElasticaWithOrderTwoAtLeast) {
  for (const int nodes : {1, 3}) {
    const double coarsest = nodes == 1 ? 1.0 / 4 : 1.0 / 8;
    const Ladder by_load = climb(coarsest, 3, [&](double h) {
      return tip_load_error(static_cast<int>(std::lround(1 / h)), tip_load[1], nodes);
    });
    EXPECT_GE(by_load.order(), 2) << by_load.print();
    const Ladder by_weight = climb(coarsest, 3, [&](double h) {
      return self_weight_error(static_cast<int>(std::lround(1 / h)), self_weight[1], nodes);
    });
    EXPECT_GE(by_weight.order(), 2) << by_weight.print();
  }
}

/// To halve a load that has no size would lead nowhere.
TEST(Cantilever, ComesToRestInRoundsOfFewIterationsUnderALoadThatStays) {
  const double weight = 50 * thick_yarn().bending_rigidity / (L * L * L);
  const Tip at_once = cantilever(16, 0, weight, 1), in_rounds = cantilever(16, 0, weight, 1, 20);
  EXPECT_EQ(at_once.rejected, 0);
  EXPECT_GT(in_rounds.rejected, 1);
  EXPECT_NEAR(in_rounds.drop, at_once.drop, 1e-6);
  EXPECT_NEAR(in_rounds.reach, at_once.reach, 1e-6);
}

/// validation.md B10: q L⁴/(8 EI) while the rod stays nearly straight.
TEST(Cantilever, SagsByTheTextbookUnderASmallWeight) {
  const double weight = 0.05 * thick_yarn().bending_rigidity / (L * L * L);
  EXPECT_NEAR(cantilever(16, 0, weight, 1).drop, 0.05 / 8, 5e-3 * 0.05 / 8);
}

}  // namespace
}  // namespace wale
