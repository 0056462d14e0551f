#include <cmath>

#include "tests/stability/hard_case.hpp"
#include "tests/stability/laid_yarns.hpp"
#include "tests/support/make_fabric.hpp"

namespace wale::stability {
namespace {

const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
const std::vector<EffectSpec> yarn{Stretch{}, Bend{}, Contact{}};

std::vector<EffectSpec> yarn_and(std::vector<EffectSpec> more) {
  std::vector<EffectSpec> all = yarn;
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

HardScene one_stage(Fabric fabric, double duration, int samples, std::vector<EffectSpec> effects) {
  HardScene hard;
  hard.scene.fabric = std::move(fabric);
  hard.scene.stages.resize(1);
  Stage& stage = hard.scene.stages.front();
  stage.duration = duration;
  stage.samples = samples;
  stage.effects = std::move(effects);
  return hard;
}

/// Segments moved by `way` (m) over the stage. Those of one scene have different labels.
Tether moved(const char* label, std::vector<int> segments, const Vec3& way, double duration) {
  return {.label = label, .segments = std::move(segments), .move = way, .progress = Schedule::ramp(0, 1, duration)};
}
Tether held(const char* label, std::vector<int> segments) { return moved(label, std::move(segments), Vec3::Zero(), 1); }

/// The first below the second, which is closed above.
const std::vector<Closing> crosswise{{0, round_by(x, -z, -x)}, {1, round_by(y, z, -y)}};
const std::vector<Closing> up_and_down{{0, round_by(-y, x, -y)}, {1, round_by(y, x, y)}};

/// They spring apart.
HardScene overlap(double share) {
  HardScene hard = one_stage(crossing((1 - share / 100) * d), 50e-6, 10, yarn_and({ContactDamping{.normal = 1e3}}));
  hard.closings = crosswise;
  hard.only_loses = hard.by_itself = true;
  return hard;
}

/// The ends of the upper yarn are moved down by `way`, m, across the lower one.
HardScene driven(double way, double speed) {
  const double duration = way / speed;
  Fabric fabric = crossing(1.2 * d);
  const std::vector<EffectSpec> effects =
      yarn_and({Drag{}, held("lower", ends_of(fabric, 0)), moved("upper", ends_of(fabric, 1), -way * z, duration)});
  HardScene hard = one_stage(std::move(fabric), duration, 20, effects);
  hard.closings = crosswise;
  return hard;
}
HardScene driven_through(double millimetres) { return driven(1e-3 * millimetres, 10); }
HardScene jerked(double speed) { return driven(4e-3, speed); }

constexpr double pull_time = 0.4e-3;  // s

/// Hooked loops pulled apart by `way`, m, in samples of 5 %.
HardScene pulled_apart(Fabric fabric, double way, std::vector<EffectSpec> more = {}, double duration = pull_time) {
  more.insert(more.end(), {Drag{}, moved("down", ends_of(fabric, 0), -way / 2 * y, duration),
                           moved("up", ends_of(fabric, 1), way / 2 * y, duration)});
  HardScene hard = one_stage(std::move(fabric), duration, 20, yarn_and(more));
  hard.closings = up_and_down;
  return hard;
}
constexpr double some_way = 1e-3;  // m, that a case which is hard in another way is pulled

HardScene pulled(double millimetres) { return pulled_apart(hooked_loops(), 1e-3 * millimetres); }

HardScene pulled_with_fine_beads(double millimetres) {
  HardScene hard = pulled(millimetres);
  for (EffectSpec& effect : hard.scene.stages.front().effects)
    if (auto* contact = std::get_if<Contact>(&effect)) contact->sampling = 0.003;
  return hard;
}

template <double Material::*property>
HardScene stiffer(double orders) {
  Material material;
  material.*property *= std::pow(10, orders);
  return pulled_apart(hooked_loops(material, material), some_way);
}
template <double Material::*property>
HardScene softer(double orders) {
  return stiffer<property>(-orders);
}

/// One half of each loop is as the material, the other so much softer in all.
HardScene soft_beside_stiff(double ratio) {
  Material soft;
  soft.axial_stiffness /= ratio;
  soft.bending_rigidity /= ratio;
  Fabric fabric = hooked_loops({}, soft);
  for (Segment& segment : fabric.segments) {
    const Yarn& of = fabric.yarns[static_cast<std::size_t>(segment.yarn)];
    const auto place = &segment - fabric.segments.data() - of.first_segment;
    segment.material = place < of.segments / 2 ? 0 : 1;
  }
  return pulled_apart(std::move(fabric), some_way);
}

HardScene rubs(double coefficient) {
  return pulled_apart(hooked_loops(), some_way, {Friction{.coefficient = coefficient, .threshold = 1e-2}});
}

/// Three of four control points follow each other at so many orders of magnitude less than the fourth, so that every
/// fourth segment is shorter by as much.
HardScene unequal(double orders) {
  Fabric fabric = crossing(0.9 * d);
  const Yarn& first = fabric.yarns.front();
  const double shorter = std::pow(10, -orders), spacing = 4 * l / (1 + 3 * shorter);
  double place = -9 * l;
  for (int k = 0; k < first.points(); ++k) {
    fabric.points(0, k) = place;
    place += k % 4 == 1 ? spacing : shorter * spacing;
  }
  fabric.points.row(0).head(first.points()).array() -= fabric.points.row(0).head(first.points()).mean();
  unstretch(fabric, 0);
  HardScene hard = one_stage(std::move(fabric), 50e-6, 10, yarn_and({ContactDamping{.normal = 1e3}}));
  hard.closings = crosswise;
  return hard;
}

/// A yarn that runs back along itself for so many of its segments, half in itself.
HardScene folded_back(double segments) {
  Fabric fabric = fabric_of();
  const double way = segments * l, beside = 0.5 * d;
  lay(fabric, {{-4 * l, 0, 0},
               {way, 0, 0},
               {way, beside, 0},
               {0, beside, 0},
               {0, 2 * beside, 0},
               {4 * l + way, 2 * beside, 0}});
  HardScene hard = one_stage(std::move(fabric), 50e-6, 10, yarn_and({Drag{}}));
  hard.only_loses = true;
  return hard;
}

/// Yarns of one segment each lie on a long one, and are pressed on it by so many times their weight.
HardScene single_segments(double weights) {
  Fabric fabric = crossing(3 * d);
  for (int k = -2; k <= 2; ++k) {
    const Vec3 at(2 * k * l, 0, 1.05 * d);
    add_yarn(fabric, straight_points(at - 0.5 * l * y, at + 0.5 * l * y, 1), l);
  }
  const std::vector<EffectSpec> effects = yarn_and(
      {Drag{}, held("lower", ends_of(fabric, 0)), held("upper", ends_of(fabric, 1)), Gravity{-9.81 * weights * z}});
  return one_stage(std::move(fabric), 200e-6, 10, effects);
}

/// Both ends of a straight strip are pushed together by so many percent of its length.
HardScene buckled(double percent) {
  Fabric fabric = fabric_of();
  const int segments = 24;
  Points points = straight_points({0, 0, 0}, {segments * l, 0, 0}, segments);
  for (int k = 0; k < points.cols(); ++k) points(1, k) += 1e-6 * std::sin(0.12 * k);
  add_yarn(fabric, points, l);
  const double way = percent / 100 * segments * l;
  const std::vector<EffectSpec> effects = yarn_and({Drag{}, moved("left", start_of(fabric, 0), way / 2 * x, pull_time),
                                                    moved("right", end_of(fabric, 0), -way / 2 * x, pull_time)});
  return one_stage(std::move(fabric), pull_time, 20, effects);
}

/// The upper yarn falls on the lower one, which is held at its ends.
HardScene falls(double weights) {
  Fabric fabric = crossing(1.5 * d);
  const double duration = 2 * std::sqrt(2 * d / (9.81 * weights));
  const std::vector<EffectSpec> effects =
      yarn_and({Drag{}, held("lower", ends_of(fabric, 0)), Gravity{-9.81 * weights * z}});
  HardScene hard = one_stage(std::move(fabric), duration, 10, effects);
  hard.closings = {crosswise[0], {1, round_by(y, z, -y)}};
  return hard;
}

/// Contact is taken away and given back at every stage of hooked loops that are held under load.
HardScene switched(double times) {
  HardScene hard = pulled_apart(hooked_loops(), some_way);
  const double duration = 2e-6;
  for (int k = 0; k < static_cast<int>(times); ++k) {
    Stage stage = hard.scene.stages.front();
    stage.samples = 1;
    stage.duration = duration;
    if (k % 2 == 0) stage.effects.erase(stage.effects.begin() + 2);
    for (EffectSpec& effect : stage.effects)
      if (auto* tether = std::get_if<Tether>(&effect)) tether->move = Vec3::Zero();
    hard.scene.stages.push_back(std::move(stage));
  }
  return hard;
}

}  // namespace

std::vector<HardCase> cases_of_yarns() {
  const std::vector<SolverKind> in_time{SolverKind::runge_kutta, SolverKind::implicit};
  return {
      {"overlap at the start", "% of d", {60}, {10, 30, 50, 60, 70, 80, 85, 90, 95}, overlap},
      {"yarn driven across yarn", "mm", {4}, {2, 3, 4, 5, 6, 8}, driven_through},
      {"yarn jerked across yarn", "m/s", {100}, {1, 10, 100, 300, 1000, 3000}, jerked},
      {"hooked loops pulled", "mm", {1}, {0.5, 1, 2, 3, 4, 6, 8}, pulled},
      {"the same, contact sampled to 0.3 %", "mm", {2}, {1, 2, 3, 4, 6, 8, 12}, pulled_with_fine_beads},
      {"EA softer", "orders of magnitude", {3}, {1, 2, 3, 4}, softer<&Material::axial_stiffness>},
      {"EA stiffer", "orders of magnitude", {2}, {1, 2, 3, 4}, stiffer<&Material::axial_stiffness>},
      {"EI softer", "orders of magnitude", {4}, {1, 2, 3, 4, 6}, softer<&Material::bending_rigidity>},
      {"EI stiffer", "orders of magnitude", {1}, {1, 2, 3, 4}, stiffer<&Material::bending_rigidity>},
      {"contact softer", "orders of magnitude", {0.5}, {0.5, 1, 2, 3}, softer<&Material::contact_stiffness>},
      {"contact stiffer", "orders of magnitude", {2}, {1, 2, 3, 4}, stiffer<&Material::contact_stiffness>},
      {"soft beside stiff in one loop", "times softer", {1e2}, {1e1, 1e2, 1e3, 1e4, 1e5, 1e6}, soft_beside_stiff},
      {"friction", "", {2}, {0, 0.3, 1, 2, 5}, rubs},
      {"unequal segments", "orders of magnitude", {0.5}, {0.5, 1, 2, 3, 4, 6, 9}, unequal},
      {"folded back", "segments", {1}, {1, 2, 4, 8}, folded_back},
      {"yarns of one segment", "times their weight", {1e3}, {1e1, 1e2, 1e3, 1e4, 1e5, 1e6}, single_segments},
      {"buckled strip", "% of its length", {40}, {1, 5, 10, 20, 40, 60, 80}, buckled},
      {"fall on a yarn", "times its weight", {1e5}, {1e3, 1e4, 1e5, 1e6, 1e7}, falls, in_time},
      // Not at rest: without contact the loops rest apart.
      {"contact switched", "times", {4}, {2, 4, 10, 20, 40}, switched, in_time},
  };
}

}  // namespace wale::stability
