#include "compiler/front/scene.hpp"

#include <gtest/gtest.h>

namespace wale {
namespace {

std::optional<ParsedScene> parse(Sources& sources, const std::string& text,
                                 const std::string& name = "some/where/scene.yaml") {
  Diagnostics say;
  auto scene = parse_scene(*sources.add(name, text), say);
  for (const Diagnostic& one : say.all()) ADD_FAILURE() << print(one);
  return scene;
}

template <class Spec>
const Spec* find(const std::vector<EffectSpec>& effects) {
  for (const EffectSpec& one : effects) {
    if (const Spec* spec = std::get_if<Spec>(&one)) return spec;
  }
  return nullptr;
}

const std::string whole = R"(scene: 1
name: jersey pulled along the wales
fabric:
  pattern: ../../patterns/jersey.yaml
  wales: 10
  courses: 11
  yarn: paper-as-printed
  stitch_length: 7.5 mm
  segments_per_stitch: 16
gauge: {thickness: 1.048 mm}
effects:
  stretch: {nodes: 2}
  bend:
  gravity: {acceleration: 9.8 m/s^2}
  drag: {coefficient: 0.5 kg/(m s)}
  contact: {sampling: 5 %, screening: 2, inflate_beads: true}
  contact_damping: {tangential: 20 N s/m^3, normal: 10 N s/m^3, sampling: 4 %, screening: 1.5}
stages:
  - {name: tighten, duration: 1 s, tighten: 90 %, hold: ends, samples: 4, grip_stiffness: 2e4 N/m^2}
  - {name: relax, duration: 500 ms, effects: {plates: {gap: 3 mm, stiffness: 2e3 N/m^2}, drag: , bend: {rest: as_laid}}}
  - name: pull
    duration: 8 s
    pull: {along: course, to: 60 %}
    solver: {runge_kutta: {method: dormand_prince, relative: 1e-5, absolute: 10 nm, first_step: 1 us, sleep: 0.1 %}}
solver: {quasi_static: {tolerance: 1e-4, iterations: 50, first_step: 10 %, smallest_step: 1e-6}}
)";

TEST(Scene, ReadsTheFabric) {
  Sources sources;
  const auto scene = parse(sources, whole);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->name, "jersey pulled along the wales");
  EXPECT_EQ(scene->pattern_path, "patterns/jersey.yaml");
  EXPECT_EQ(scene->overrides.wales, 10);
  EXPECT_EQ(scene->overrides.courses, 11);
  EXPECT_EQ(scene->overrides.materials.otherwise->name, "paper-as-printed");
  EXPECT_DOUBLE_EQ(*scene->overrides.stitch_length, 7.5e-3);
  EXPECT_EQ(scene->segments_per_stitch, 16);
  EXPECT_DOUBLE_EQ(scene->thickness, 1.048e-3);
}

TEST(Scene, GivesTheCommonEffectsToEveryStage) {
  Sources sources;
  const auto scene = parse(sources, whole);
  ASSERT_TRUE(scene);
  ASSERT_EQ(scene->stages.size(), 3u);
  for (const Stage& stage : scene->stages) {
    EXPECT_EQ(find<Stretch>(stage.effects)->nodes, 2);
    EXPECT_EQ(find<Bend>(stage.effects)->nodes, Bend{}.nodes);
    EXPECT_EQ(find<Gravity>(stage.effects)->acceleration, Vec3(0, -9.8, 0));
    EXPECT_DOUBLE_EQ(find<Contact>(stage.effects)->sampling, 0.05);
    EXPECT_DOUBLE_EQ(find<Contact>(stage.effects)->screening, 2);
    EXPECT_TRUE(find<Contact>(stage.effects)->inflate_beads);
    EXPECT_DOUBLE_EQ(find<ContactDamping>(stage.effects)->tangential, 20);
    EXPECT_DOUBLE_EQ(find<ContactDamping>(stage.effects)->normal, 10);
    EXPECT_DOUBLE_EQ(find<ContactDamping>(stage.effects)->sampling, 0.04);
    EXPECT_DOUBLE_EQ(find<ContactDamping>(stage.effects)->screening, 1.5);
  }
}

TEST(Scene, AStageAddsToTheCommonEffectsOrReplacesThem) {
  Sources sources;
  const auto scene = parse(sources, whole);
  ASSERT_TRUE(scene);
  EXPECT_EQ(find<Plates>(scene->stages[0].effects), nullptr);
  EXPECT_DOUBLE_EQ(find<Plates>(scene->stages[1].effects)->gap, 3e-3);
  EXPECT_DOUBLE_EQ(find<Plates>(scene->stages[1].effects)->stiffness, 2e3);
  EXPECT_DOUBLE_EQ(find<Drag>(scene->stages[0].effects)->coefficient, 0.5);
  EXPECT_DOUBLE_EQ(find<Drag>(scene->stages[1].effects)->coefficient, Drag{}.coefficient);
  EXPECT_EQ(find<Bend>(scene->stages[0].effects)->rest, RestShape::straight);
  EXPECT_EQ(find<Bend>(scene->stages[1].effects)->rest, RestShape::as_laid);
  EXPECT_EQ(scene->stages[1].effects.size(), scene->stages[0].effects.size() + 1);
}

TEST(Scene, ReadsStagesAndSolvers) {
  Sources sources;
  const auto scene = parse(sources, whole);
  ASSERT_TRUE(scene);
  const Stage &tighten = scene->stages[0], &relax = scene->stages[1], &pull = scene->stages[2];
  EXPECT_EQ(tighten.name, "tighten");
  EXPECT_DOUBLE_EQ(*tighten.tighten, 0.9);
  EXPECT_EQ(tighten.hold, Hold::ends);
  EXPECT_EQ(tighten.samples, 4);
  EXPECT_DOUBLE_EQ(tighten.grip_stiffness, 2e4);
  EXPECT_DOUBLE_EQ(relax.duration, 0.5);
  EXPECT_FALSE(relax.tighten || relax.pull);
  EXPECT_EQ(pull.pull->along, Along::course);
  EXPECT_EQ(pull.pull->strains, std::vector{0.6});
  const auto& equilibria = std::get<QuasiStatic>(relax.solver);
  EXPECT_DOUBLE_EQ(equilibria.tolerance, 1e-4);
  EXPECT_EQ(equilibria.iterations, 50);
  EXPECT_DOUBLE_EQ(equilibria.first_step, 0.1);
  EXPECT_DOUBLE_EQ(equilibria.smallest_step, 1e-6);
  const auto& explicit_solver = std::get<RungeKutta>(pull.solver);
  EXPECT_EQ(explicit_solver.method, RungeKutta::Method::dormand_prince);
  EXPECT_DOUBLE_EQ(explicit_solver.relative, 1e-5);
  EXPECT_DOUBLE_EQ(explicit_solver.absolute, 1e-8);
  EXPECT_DOUBLE_EQ(explicit_solver.first_step, 1e-6);
  EXPECT_DOUBLE_EQ(explicit_solver.sleep, 1e-3);
}

TEST(Scene, ReadsStrainsOneAfterTheOther) {
  Sources sources;
  const auto scene = parse(sources,
                           "scene: 1\nfabric: {pattern: a.yaml}\neffects: {stretch: }\n"
                           "stages: [{name: cycle, duration: 4 s, pull: {along: wale, to: [60 %, 0 %, 60 %, 0 %]}}]\n");
  ASSERT_TRUE(scene);
  EXPECT_FALSE(scene->overrides.periodic);
  EXPECT_EQ(scene->stages[0].pull->strains, (std::vector<double>{0.6, 0, 0.6, 0}));
}

TEST(Scene, ReadsWhatBecomesOfThePeriods) {
  Sources sources;
  const auto scene = parse(sources, R"(scene: 1
fabric: {pattern: rib.yaml, wales: 2, courses: 2, periodic: true}
effects: {stretch: }
stages:
  - {name: tighten, duration: 1 s, tighten: 100 %, deform: {shear: held}}
  - {name: rest, duration: 1 s, hold: periods}
  - {name: crush, duration: 1 s, pull: {along: course, to: -10 %}}
  - {name: both, duration: 1 s, deform: {wale: [100 %, 0 %], course: [0 %, -20 %]}}
)");
  ASSERT_TRUE(scene);
  EXPECT_TRUE(scene->overrides.periodic);
  using How = Deform::How;
  EXPECT_EQ(scene->stages[0].deform, (Deform{.shear = {How::held, {}}}));
  EXPECT_EQ(scene->stages[1].hold, Hold::periods);
  EXPECT_EQ(scene->stages[2].pull->strains, std::vector{-0.1});
  EXPECT_EQ(scene->stages[3].deform, (Deform{.wale = {How::driven, {1, 0}}, .course = {How::driven, {0, -0.2}}}));
}

TEST(Scene, HasDefaultsForWhatItDoesNotSay) {
  Sources sources;
  const auto scene = parse(sources,
                           "scene: 1\nfabric: {pattern: a.yaml}\neffects: {stretch: }\nsolver: runge_kutta\n"
                           "stages: [{name: relax, duration: 1 s}]\n",
                           "swatch.yaml");
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->name, "swatch");
  EXPECT_EQ(scene->pattern_path, "a.yaml");
  EXPECT_FALSE(scene->overrides.wales || scene->overrides.materials.otherwise || scene->overrides.stitch_length);
  EXPECT_EQ(scene->segments_per_stitch, 12);
  EXPECT_EQ(scene->thickness, 0);
  EXPECT_EQ(scene->stages[0].effects.size(), 1u);
  EXPECT_EQ(std::get<RungeKutta>(scene->stages[0].solver).method, RungeKutta::Method::kutta);
}

TEST(Scene, MayFollowTheMotionImplicitly) {
  Sources sources;
  const auto scene = parse(sources, R"(scene: 1
fabric: {pattern: a.yaml}
effects: {stretch: , friction: {coefficient: 0.2, threshold: 0.1 mm/s}}
solver: implicit
stages:
  - {name: drop, duration: 1 s}
  - name: snap
    duration: 1 s
    solver: {implicit: {relative: 1e-4, absolute: 1 nm, absolute_speed: 1 mm/s, first_step: 1 us, iterations: 9}}
)");
  ASSERT_TRUE(scene);
  EXPECT_DOUBLE_EQ(std::get<Implicit>(scene->stages[0].solver).relative, Implicit{}.relative);
  const auto& implicit = std::get<Implicit>(scene->stages[1].solver);
  EXPECT_DOUBLE_EQ(implicit.relative, 1e-4);
  EXPECT_DOUBLE_EQ(implicit.absolute, 1e-9);
  EXPECT_DOUBLE_EQ(implicit.absolute_speed, 1e-3);
  EXPECT_DOUBLE_EQ(implicit.first_step, 1e-6);
  EXPECT_EQ(implicit.iterations, 9);
  EXPECT_DOUBLE_EQ(find<Friction>(scene->stages[0].effects)->coefficient, 0.2);
  EXPECT_DOUBLE_EQ(find<Friction>(scene->stages[0].effects)->threshold, 1e-4);
}

TEST(Scene, MayGiveStitchLengthsBySettingAsAMapOrAsTheCommandLineDoes) {
  for (const char* lengths : {"{otherwise: 9 mm, 6: 9.5 mm, 25/40: 8 mm}", "\"9 mm, 6 = 9.5 mm, 25/40 = 8 mm\""}) {
    Sources sources;
    const auto scene = parse(sources, std::string("scene: 1\nfabric: {pattern: a.k, stitch_length: ") + lengths +
                                          "}\neffects: {bend: }\nstages: [{name: relax, duration: 1 s}]\n");
    ASSERT_TRUE(scene);
    EXPECT_DOUBLE_EQ(scene->knitout.stitch_lengths.at("5"), 9e-3);
    EXPECT_DOUBLE_EQ(scene->knitout.stitch_lengths.at("6"), 9.5e-3);
    EXPECT_DOUBLE_EQ(scene->knitout.stitch_lengths.at("25/40"), 8e-3);
    EXPECT_FALSE(scene->overrides.stitch_length);
  }
}

TEST(Scene, GravityMayBeAVector) {
  Sources sources;
  const auto scene = parse(sources,
                           "scene: 1\nfabric: {pattern: a.yaml}\n"
                           "effects: {gravity: {acceleration: [1 m/s^2, 0 m/s^2, -2 m/s^2]}}\n"
                           "stages: [{name: relax, duration: 1 s}]\n");
  ASSERT_TRUE(scene);
  EXPECT_EQ(find<Gravity>(scene->stages[0].effects)->acceleration, Vec3(1, 0, -2));
}

TEST(Scene, AnAbsolutePathOfAPatternStaysAsItIs) {
  Sources sources;
  const auto scene = parse(sources,
                           "scene: 1\nfabric: {pattern: /charts/a.yaml}\neffects: {bend: }\n"
                           "stages: [{name: relax, duration: 1 s}]\n");
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->pattern_path, "/charts/a.yaml");
}

TEST(Scene, ReadsBodiesPressureTorqueAndShrinkingYarn) {
  Sources sources;
  const auto scene = parse(sources, R"(scene: 1
fabric: {pattern: tube.yaml}
effects: {stretch: , obstacle: {plane: {point: [0 mm, 1 mm, 0 mm], normal: [0, 3, 4]}}}
stages:
  - {name: rest, duration: 2 s}
  - name: press
    duration: 4 s
    shrink: [{by: 10 %}, {yarn: [a, b], by: -5 %}]
    effects:
      obstacle:
        - {sphere: {centre: [1 mm, 2 mm, -8 mm], radius: 5 mm}, move: [0 mm, 0 mm, 4 mm], stiffness: 1e5 N/m^2, on: c}
        - cylinder: {centre: [0 mm, 0 mm, 9 mm], axis: [0, 2, 0], radius: 1 mm}
      pressure: {from: 1 kPa, to: 3 kPa, spacing: 0.9 mm}
      twist: {to: 2e-7 N m}
)");
  ASSERT_TRUE(scene);
  const auto* table = find<Obstacle>(scene->stages[0].effects);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->shape, Obstacle::Shape::plane);
  EXPECT_LT((table->axis - Vec3(0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_EQ(table->progress(2), 1);

  const Stage& press = scene->stages[1];
  ASSERT_EQ(press.effects.size(), 5u) << "the table is replaced by two bodies";
  const auto& ball = std::get<Obstacle>(press.effects[1]);
  const auto& rod = std::get<Obstacle>(press.effects[2]);
  EXPECT_EQ(ball.label, "obstacle.1");
  EXPECT_EQ(ball.shape, Obstacle::Shape::sphere);
  EXPECT_LT((ball.centre - Vec3(1e-3, 2e-3, -8e-3)).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(ball.radius, 5e-3);
  EXPECT_DOUBLE_EQ(ball.stiffness, 1e5);
  EXPECT_DOUBLE_EQ(ball.move.z(), 4e-3);
  EXPECT_EQ(ball.progress(1), 0.25);
  EXPECT_EQ(rod.shape, Obstacle::Shape::cylinder);
  EXPECT_EQ(rod.axis, Vec3::UnitY());
  const auto* pressure = find<Pressure>(press.effects);
  EXPECT_DOUBLE_EQ(pressure->from, 1e3);
  EXPECT_DOUBLE_EQ(pressure->to, 3e3);
  EXPECT_DOUBLE_EQ(pressure->spacing, 0.9e-3);
  EXPECT_EQ(pressure->progress(2), 0.5);
  EXPECT_DOUBLE_EQ(find<Twist>(press.effects)->to, 2e-7);

  ASSERT_EQ(press.shrink.size(), 2u);
  EXPECT_TRUE(press.shrink[0].materials.empty());
  EXPECT_DOUBLE_EQ(press.shrink[0].by, 0.1);
  EXPECT_DOUBLE_EQ(press.shrink[1].by, -0.05);
  const auto name = [&](int place) { return scene->mentions.yarns.at(static_cast<std::size_t>(place)).name; };
  ASSERT_EQ(press.shrink[1].materials.size(), 2u);
  EXPECT_EQ(name(press.shrink[1].materials[1]), "b");
  EXPECT_EQ(name(ball.on.materials.at(0)), "c");
}

}  // namespace
}  // namespace wale
