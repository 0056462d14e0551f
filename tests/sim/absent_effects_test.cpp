// An effect that a scene does not call for costs nothing: no object, no memory, no work, no column.
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/compile.hpp"
#include "sim/run.hpp"
#include "sim/world.hpp"
#include "tests/support/allocations.hpp"
#include "tests/support/one_thread.hpp"

namespace wale {
namespace {

Scene scene_with(const std::string& effects) {
  Sources sources;
  Diagnostics say;
  sources.add("chart.yaml", "knit: 1\nwales: 3\nbands: [{stitch: jersey, courses: 3}]\n");
  return compile_scene(
             *sources.add("scene.yaml", "scene: 1\nfabric: {pattern: chart.yaml}\neffects: " + effects +
                                            "\nstages: [{name: rest, duration: 1 s, samples: 1, tighten: 5 %}]\n"),
             sources, say)
      .value();
}

/// Of every kind, as a scene names them, and its objects' name.
struct Kind {
  std::string name;
  EffectSpec spec;
};
std::vector<Kind> kinds() {
  Tether tether;
  tether.segments = {0, 1, 2};
  std::vector<Kind> all;
  const auto add = [&](std::string name, auto spec) {
    all.push_back(Kind{std::move(name), EffectSpec(std::move(spec))});
  };
  add("stretch", Stretch{});
  add("bend", Bend{});
  add("gravity", Gravity{});
  add("drag", Drag{});
  add("contact", Contact{});
  add("contact_damping", ContactDamping{20, 10});
  add("friction", Friction{});
  add("plates", Plates{});
  add("tether", tether);
  add("obstacle", Obstacle{.centre = {0, 0, -1e-3}});
  add("twist", Twist{.to = 1e-9});
  return all;
}

std::vector<EffectSpec> all_but(const std::string& absent) {
  std::vector<EffectSpec> effects;
  for (const Kind& kind : kinds())
    if (kind.name != absent) effects.push_back(kind.spec);
  return effects;
}

class AbsentEffect : public testing::TestWithParam<std::string> {
 protected:
  const Scene scene_ = scene_with("{stretch: }");
  State state_ = at_rest(scene_.fabric);
  const OneThread one_thread_;

  World world(std::vector<EffectSpec> effects) const { return {scene_.fabric, std::move(effects), 0.0, state_}; }
  /// Of making the world and evaluating once, bytes.
  std::size_t memory(const std::vector<EffectSpec>& effects) {
    return test::allocations_of([&] {
             World made = world(effects);
             evaluate(made);
           })
        .bytes;
  }
  void evaluate(World& made) {
    Load load{.energy = &energy_, .force = &force_};
    made.prepare(state_);
    made.evaluate(state_, load);
  }

  double energy_ = 0;
  Points force_ = Points::Zero(3, state_.q.cols());
};

bool rolls_beads(const std::string& name) {
  return name == "contact" || name == "contact_damping" || name == "friction";
}

TEST_P(AbsentEffect, IsNoObjectAndHoldsNoMemory) {
  const World made = world(all_but(GetParam()));
  EXPECT_EQ(made.effects().size(), kinds().size() - 1);
  for (const auto& effect : made.effects()) EXPECT_NE(effect->name(), GetParam());
  if (!test::counts_allocations()) return;
  EXPECT_LT(memory(all_but(GetParam())), memory(all_but("")));
}

TEST_P(AbsentEffect, AloneMakesOnlyWhatItNeeds) {
  const auto all = kinds();
  const auto kind = std::find_if(all.begin(), all.end(), [](const Kind& each) { return each.name == GetParam(); });
  World alone = world({kind->spec});
  evaluate(alone);
  ASSERT_EQ(alone.effects().size(), 1u);
  EXPECT_EQ(alone.effects().front()->name(), GetParam());
  EXPECT_EQ(alone.parts().made_beads.empty(), !rolls_beads(GetParam())) << "beads are for what touches";
}

/// Those that share nothing; what touches shares its beads.
class AbsentEffectOfItsOwn : public AbsentEffect {};

TEST_P(AbsentEffectOfItsOwn, LeavesMemoryToTheOthersAlone) {
  if (!test::counts_allocations()) GTEST_SKIP() << "the heap cannot be watched here";
  const auto all = kinds();
  const auto kind = std::find_if(all.begin(), all.end(), [](const Kind& each) { return each.name == GetParam(); });
  const std::size_t nothing = memory({}), alone = memory({kind->spec});
  const std::size_t with = memory(all_but("")), without = memory(all_but(GetParam()));
  EXPECT_NEAR(static_cast<double>(with - without), static_cast<double>(alone - nothing), 2048)
      << "an effect takes with others what it takes alone";
}

std::string name_of(const testing::TestParamInfo<std::string>& of) { return of.param; }

INSTANTIATE_TEST_SUITE_P(EachEffect, AbsentEffect,
                         testing::Values("stretch", "bend", "gravity", "drag", "contact", "contact_damping", "friction",
                                         "plates", "tether", "obstacle", "twist"),
                         name_of);
INSTANTIATE_TEST_SUITE_P(EachEffect, AbsentEffectOfItsOwn,
                         testing::Values("stretch", "bend", "gravity", "drag", "plates", "tether", "obstacle", "twist"),
                         name_of);

TEST(Evaluation, AsksOfTheHeapWhatItsEffectsAskAlone) {
  if (!test::counts_allocations()) GTEST_SKIP() << "the heap cannot be watched here";
  const OneThread one_thread;
  const Scene scene = scene_with("{stretch: }");
  const State state = at_rest(scene.fabric);
  const auto calls = [&](std::vector<EffectSpec> effects) {
    World world(scene.fabric, std::move(effects), 0.0, state);
    double energy = 0;
    Points force = Points::Zero(3, state.q.cols());
    Load load{.energy = &energy, .force = &force};
    world.prepare(state);
    world.evaluate(state, load);
    return test::allocations_of([&] { world.evaluate(state, load); }).calls;
  };
  std::size_t sum = 0;
  for (const Kind& kind : kinds()) sum += calls({kind.spec});
  EXPECT_EQ(calls({}), 0u);
  EXPECT_EQ(calls(all_but("")), sum);
}

/// Counts how often it is asked.
class Counting : public Effect {
 public:
  Counting(bool dissipates, int& asked) : dissipates_(dissipates), asked_(asked) {}
  std::string_view name() const override { return "counting"; }
  bool dissipative() const override { return dissipates_; }
  void add(const State&, Load&) const override { ++asked_; }

 private:
  bool dissipates_;
  int& asked_;
};

TEST(Evaluation, AsksEachEffectThatIsMeantOnceAndNoOther) {
  const Scene scene = scene_with("{stretch: }");
  const State state = at_rest(scene.fabric);
  World world(scene.fabric, {Stretch{}}, 0.0, state);
  int elastic = 0, dissipative = 0;
  world.add(std::make_unique<Counting>(false, elastic));
  world.add(std::make_unique<Counting>(true, dissipative));
  Load load;
  world.evaluate(state, load, Acting::elastic);
  EXPECT_EQ(elastic, 1);
  EXPECT_EQ(dissipative, 0);
  world.evaluate(state, load, Acting::dissipative);
  EXPECT_EQ(elastic, 1);
  EXPECT_EQ(dissipative, 1);
  world.evaluate(state, load);
  EXPECT_EQ(elastic, 2);
  EXPECT_EQ(dissipative, 2);
}

TEST(Columns, AreOfEffectsThatAreThere) {
  Results results;
  results.scene = scene_with("{stretch: , bend: }");
  ASSERT_EQ(run(results, {}), Outcome::finished);
  std::vector<std::string> energies;
  for (const Column& column : results.samples.columns)
    if (column.name.starts_with("energy.") && column.name != "energy.kinetic") energies.push_back(column.name);
  EXPECT_EQ(energies, (std::vector<std::string>{"energy.stretch", "energy.bend"}));
  EXPECT_FALSE(results.samples.find("force")) << "nothing is gripped";
}

}  // namespace
}  // namespace wale
