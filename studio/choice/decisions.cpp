#include "studio/choice/decisions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "studio/accuracy/sentences.hpp"

namespace wale {
namespace {

constexpr double share_of_accuracy = 0.25;  // that one effect left out may take
constexpr double at_rest = 0.1;             // the strain whose force at-rest stages are compared with
constexpr double milli = 1e3;

/// One stage and what its effects are weighed against.
class Weighing {
 public:
  Weighing(const Scene& scene, int place, const Scales& scales)
      : scene_(scene), stage_(scene.stages[static_cast<std::size_t>(place)]), place_(place), of_(scales) {}

  Decision operator()(const Stretch&) const { return kept("stretch", "yarn bears its load by stretching"); }
  Decision operator()(const Bend&) const { return kept("bend", "what gives loops their shape"); }
  Decision operator()(const Contact&) const { return kept("contact", "without it yarns pass through each other"); }
  Decision operator()(const Knots&) const { return kept("knots", "without them loose ends creep out"); }
  template <class Other>
  Decision operator()(const Other&) const {
    return kept("", "");
  }

  Decision operator()(const Gravity& spec) const {
    const double weight = of_.linear_density * of_.stitch_length * scene_.gauge.courses * spec.acceleration.norm();
    return weighed("gravity", weight / load(),
                   fmt::format("the weight of a wale, {:.2g} mN, against {}", milli * weight, load_words()), spec);
  }

  Decision operator()(const Friction& spec) const {
    if (!stage_.strains() && scene_.fabric.cell)
      return left_out("friction", 0, "nothing is strained, and rest without it is where handling brings a fabric",
                      spec);
    const double more = std::exp(spec.coefficient * std::numbers::pi / 2) - 1;
    return weighed("friction", more,
                   fmt::format("yarn that slides a quarter turn around yarn, µ = {:g} (capstan)", spec.coefficient),
                   spec);
  }

  Decision operator()(const Drag& spec) const {
    if (std::holds_alternative<QuasiStatic>(stage_.solver))
      return left_out("drag", 0, "nothing moves from equilibrium to equilibrium", spec);
    const double force = 2 * spec.coefficient * speed() * of_.stitch_length * scene_.gauge.courses / 2;
    return weighed("drag", force / load(),
                   fmt::format("{:.2g} mN on a wale at {:.2g} m/s, against {}", milli * force, speed(), load_words()),
                   spec);
  }

  Decision operator()(const Twist& spec) const {
    const double torque = std::max(std::abs(spec.from), std::abs(spec.to));
    const double moment = of_.bending_force * of_.diameter * of_.diameter / (of_.stitch_length / 4);
    return weighed("twist", torque / moment,
                   fmt::format("{:.2g} µN m against {:.2g} µN m that bend a loop", 1e6 * torque, 1e6 * moment), spec);
  }

  /// Kinetic energy over the work of the load, for a fabric one end of which is led.
  Decision inertia() const {
    const double mass = of_.linear_density * of_.stitch_length * scene_.gauge.courses;
    const double work = load() * std::max(greatest_strain(stage_), at_rest) * height() / 2;
    const double share = mass * speed() * speed() / 6 / work;
    return {place_,
            stage_.name,
            stage_.strains(),
            "inertia",
            true,
            share,
            fmt::format("kinetic energy at {:.2g} m/s against the work of {}", speed(), load_words())};
  }

 private:
  double height() const { return of_.stitch_length / 5 * scene_.gauge.courses; }  // Munden 1959: a course each l/5
  double speed() const { return strain_path(stage_) * height() / stage_.duration; }
  double load() const { return of_.bending_force * std::max(greatest_strain(stage_), at_rest); }
  std::string load_words() const {
    return fmt::format("{:.2g} mN ({:g} % strain of EI/d²)", milli * load(),
                       100 * std::max(greatest_strain(stage_), at_rest));
  }

  Decision kept(std::string effect, std::string why) const {
    return {place_, stage_.name, stage_.strains(), std::move(effect), true, {}, std::move(why)};
  }
  Decision weighed(std::string effect, double estimate, std::string why, EffectSpec spec) const {
    return {place_, stage_.name, stage_.strains(), std::move(effect), true, estimate, std::move(why), std::move(spec)};
  }
  Decision left_out(std::string effect, double estimate, std::string why, EffectSpec spec) const {
    return {place_, stage_.name, stage_.strains(), std::move(effect), false, estimate, std::move(why), std::move(spec)};
  }

  const Scene& scene_;
  const Stage& stage_;
  int place_;
  const Scales& of_;
};

void decide_solver(Stage& stage, const Weighing& weigh, bool periodic, double accuracy,
                   std::vector<Decision>& decisions) {
  if (!stage.solver_open || !stage.strains()) return;
  Decision inertia = weigh.inertia();
  inertia.taken = inertia.estimate >= share_of_accuracy * accuracy && !periodic;
  if (inertia.taken) stage.solver = Implicit{};
  if (periodic && inertia.estimate >= share_of_accuracy * accuracy)
    inertia.why += "; a fabric without end is followed in time only where `solver` says so";
  decisions.push_back(std::move(inertia));
}

void decide_stage(Scene& scene, int place, const Scales& scales, double accuracy, std::vector<Decision>& decisions) {
  Stage& stage = scene.stages[static_cast<std::size_t>(place)];
  const Weighing weigh(scene, place, scales);
  decide_solver(stage, weigh, scene.fabric.cell.has_value(), accuracy, decisions);
  std::vector<EffectSpec> taken;
  for (EffectSpec& effect : stage.effects) {
    Decision decision = std::visit(weigh, effect);
    decision.taken = decision.taken && (!decision.estimate || *decision.estimate >= share_of_accuracy * accuracy);
    if (decision.taken) decision.left_out.reset();
    if (decision.taken) taken.push_back(std::move(effect));
    if (!decision.effect.empty()) decisions.push_back(std::move(decision));
  }
  stage.effects = std::move(taken);
}

}  // namespace

std::vector<Decision> decide_effects(Scene& scene, const Scales& scales, double accuracy) {
  std::vector<Decision> decisions;
  for (int place = 0; place < static_cast<int>(scene.stages.size()); ++place)
    if (scene.stages[static_cast<std::size_t>(place)].effects_open)
      decide_stage(scene, place, scales, accuracy, decisions);
  return decisions;
}

bool is_borderline(const Decision& decision, double accuracy) {
  constexpr double worth_a_look = 0.1;
  return decision.left_out && decision.estimate && *decision.estimate >= worth_a_look * share_of_accuracy * accuracy;
}

std::string words_of(const std::vector<Decision>& decisions) {
  std::string text;
  int stage = -1;
  for (const Decision& decision : decisions) {
    if (decision.stage != std::exchange(stage, decision.stage)) text += fmt::format("Stage {}\n", decision.stage_name);
    text += fmt::format("  {:<9} {:<9} ", decision.effect, decision.taken ? "in" : "left out");
    if (decision.estimate)
      text += fmt::format("changes the {} by an estimated {}: ", decision.strained ? "stress" : "rest",
                          percent(*decision.estimate));
    text += decision.why + "\n";
  }
  return text;
}

}  // namespace wale
