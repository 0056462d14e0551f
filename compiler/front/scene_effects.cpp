#include <fmt/format.h>

#include <algorithm>

#include "compiler/front/scene_parts.hpp"
#include "compiler/front/scene_settings.hpp"

namespace wale {
namespace {

constexpr Range samplings{1e-4, 0.5}, screenings{0.5, 20}, skins{0.01, 5}, tolerances{1e-14, 0.1},
    residuals{1e-14, 1e3}, shares{1e-12, 1};
constexpr int most_nodes = 5;

Stretch read_stretch(const YamlNode& node, Diagnostics& say) {
  Stretch spec;
  Settings(node, "stretch", {"nodes"}, say).count("nodes", 1, most_nodes, spec.nodes);
  return spec;
}

Bend read_bend(const YamlNode& node, Diagnostics& say) {
  Bend spec;
  const Settings settings(node, "bend", {"nodes", "rest"}, say);
  settings.count("nodes", 1, most_nodes, spec.nodes);
  if (const YamlNode* rest = settings.find("rest"))
    spec.rest = read_word(*rest, "the rest shape", {"straight", "as_laid"}, say).value_or(0) == 1 ? RestShape::as_laid
                                                                                                  : RestShape::straight;
  return spec;
}

/// One number points down, along -y; three are a vector.
Gravity read_gravity(const YamlNode& node, Mentions& mentions, Diagnostics& say) {
  constexpr Range down{0, 1000}, any{-1000, 1000};
  Gravity spec;
  const Settings settings(node, "gravity", {"acceleration", "on"}, say);
  settings.part("on", mentions, spec.on);
  const YamlNode* given = settings.find("acceleration");
  if (!given || given->kind != YamlNode::Kind::list) {
    double g = -spec.acceleration.y();
    settings.quantity("acceleration", dimensions::acceleration, down, g);
    spec.acceleration = {0, -g, 0};
    return spec;
  }
  settings.vector("acceleration", "an acceleration", dimensions::acceleration, any,
                  "write `[0 m/s^2, -9.81 m/s^2, 0 m/s^2]`, or one number for straight down", spec.acceleration);
  return spec;
}

Drag read_drag(const YamlNode& node, Mentions& mentions, Diagnostics& say) {
  Drag spec;
  const Settings settings(node, "drag", {"coefficient", "on"}, say);
  settings.quantity("coefficient", dimensions::drag, {0, 1e6}, spec.coefficient);
  settings.part("on", mentions, spec.on);
  return spec;
}

Contact read_contact(const YamlNode& node, Diagnostics& say) {
  Contact spec;
  const Settings settings(node, "contact", {"sampling", "screening", "skin", "inflate_beads"}, say);
  settings.quantity("sampling", dimensions::ratio, samplings, spec.sampling);
  settings.quantity("screening", dimensions::ratio, screenings, spec.screening);
  settings.quantity("skin", dimensions::ratio, skins, spec.skin);
  settings.flag("inflate_beads", spec.inflate_beads);
  return spec;
}

ContactDamping read_contact_damping(const YamlNode& node, Diagnostics& say) {
  constexpr Range coefficients{0, 1e12};
  ContactDamping spec;
  const Settings settings(node, "contact_damping", {"tangential", "normal", "sampling", "screening", "skin"}, say);
  settings.quantity("tangential", dimensions::contact_damping, coefficients, spec.tangential);
  settings.quantity("normal", dimensions::contact_damping, coefficients, spec.normal);
  settings.quantity("sampling", dimensions::ratio, samplings, spec.sampling);
  settings.quantity("screening", dimensions::ratio, screenings, spec.screening);
  settings.quantity("skin", dimensions::ratio, skins, spec.skin);
  return spec;
}

Friction read_friction(const YamlNode& node, Diagnostics& say) {
  Friction spec;
  const Settings settings(node, "friction", {"coefficient", "threshold", "sampling", "screening", "skin"}, say);
  settings.quantity("coefficient", dimensions::ratio, {0, 10}, spec.coefficient);
  settings.quantity("threshold", dimensions::speed, {1e-12, 100}, spec.threshold);
  settings.quantity("sampling", dimensions::ratio, samplings, spec.sampling);
  settings.quantity("screening", dimensions::ratio, screenings, spec.screening);
  settings.quantity("skin", dimensions::ratio, skins, spec.skin);
  return spec;
}

Plates read_plates(const YamlNode& node, Diagnostics& say) {
  Plates spec;
  const Settings settings(node, "plates", {"gap", "stiffness"}, say);
  settings.quantity("gap", dimensions::length, {1e-6, 1}, spec.gap);
  settings.quantity("stiffness", dimensions::foundation, {1e-6, 1e12}, spec.stiffness);
  return spec;
}

/// How it changes is told in shares of the stage.
Pressure read_pressure(const YamlNode& node, Mentions& mentions, Diagnostics& say) {
  constexpr Range pressures{-1e9, 1e9};
  Pressure spec;
  mentions.tubes.push_back(node.span);
  const Settings settings(node, "pressure", {"from", "to", "spacing"}, say);
  settings.require("to", "add the pressure at the end of the stage, as in `to: 2 kPa`");
  settings.quantity("from", dimensions::stress, pressures, spec.from);
  settings.quantity("to", dimensions::stress, pressures, spec.to);
  settings.quantity("spacing", dimensions::length, {1e-6, 1}, spec.spacing);
  spec.progress = Schedule::ramp(0, 1, 1);
  return spec;
}

Twist read_twist(const YamlNode& node, Mentions& mentions, Diagnostics& say) {
  constexpr Range torques{-1, 1};
  Twist spec;
  const Settings settings(node, "twist", {"from", "to", "on"}, say);
  settings.require("to", "add the torque at the end of the stage, as in `to: 1e-6 N m`");
  settings.quantity("from", dimensions::torque, torques, spec.from);
  settings.quantity("to", dimensions::torque, torques, spec.to);
  settings.yarns("on", mentions, spec.materials);
  spec.progress = Schedule::ramp(0, 1, 1);
  return spec;
}

/// Which ends are tied is found when the fabric is compiled.
Knots read_knots(const YamlNode& node, Diagnostics& say) {
  Knots spec;
  Settings(node, "knots", {"stiffness"}, say).quantity("stiffness", dimensions::spring, {1e-6, 1e9}, spec.stiffness);
  return spec;
}

QuasiStatic read_quasi_static(const YamlNode& node, Diagnostics& say) {
  QuasiStatic spec;
  const Settings settings(node, "quasi_static", {"tolerance", "of_load", "iterations", "first_step", "smallest_step"},
                          say);
  settings.quantity("tolerance", dimensions::ratio, residuals, spec.tolerance);
  settings.quantity("of_load", dimensions::ratio, residuals, spec.of_load);
  settings.count("iterations", 1, 1'000'000, spec.iterations);
  settings.quantity("first_step", dimensions::ratio, {0, 1}, spec.first_step);
  settings.quantity("smallest_step", dimensions::ratio, shares, spec.smallest_step);
  return spec;
}

RungeKutta read_runge_kutta(const YamlNode& node, Diagnostics& say) {
  RungeKutta spec;
  const Settings settings(node, "runge_kutta", {"method", "relative", "absolute", "first_step", "sleep"}, say);
  if (const YamlNode* method = settings.find("method"))
    spec.method = read_word(*method, "the method", {"kutta", "dormand_prince"}, say).value_or(0) == 1
                      ? RungeKutta::Method::dormand_prince
                      : RungeKutta::Method::kutta;
  // With more an undamped mode runs away unnoticed: see docs/solvers.md.
  constexpr Range watchful{tolerances.least, 1e-3};
  const bool is_kutta = spec.method == RungeKutta::Method::kutta;
  settings.quantity("relative", dimensions::ratio, is_kutta ? tolerances : watchful, spec.relative);
  settings.quantity("absolute", dimensions::length, {1e-15, 1e-2}, spec.absolute);
  settings.quantity("first_step", dimensions::time, {0, 1e3}, spec.first_step);
  settings.quantity("sleep", dimensions::ratio, {0, 1}, spec.sleep);
  return spec;
}

Implicit read_implicit(const YamlNode& node, Diagnostics& say) {
  Implicit spec;
  const Settings settings(node, "implicit", {"relative", "absolute", "absolute_speed", "first_step", "iterations"},
                          say);
  settings.quantity("relative", dimensions::ratio, tolerances, spec.relative);
  settings.quantity("absolute", dimensions::length, {1e-15, 1e-2}, spec.absolute);
  settings.quantity("absolute_speed", dimensions::speed, {1e-12, 100}, spec.absolute_speed);
  settings.quantity("first_step", dimensions::time, {0, 1e3}, spec.first_step);
  settings.count("iterations", 1, 1'000'000, spec.iterations);
  return spec;
}

/// One word, or a map with settings.
struct SolverReader {
  std::string_view key;
  SolverSpec (*read)(const YamlNode&, Diagnostics&);
};

template <auto read>
SolverSpec as_solver(const YamlNode& node, Diagnostics& say) {
  return read(node, say);
}

constexpr SolverReader solver_readers[] = {
    {"quasi_static", as_solver<read_quasi_static>},
    {"runge_kutta", as_solver<read_runge_kutta>},
    {"implicit", as_solver<read_implicit>},
};

struct EffectReader {
  std::string_view key;
  /// At least one.
  std::vector<EffectSpec> (*read)(const YamlNode&, Mentions&, Diagnostics&);
};

template <auto read>
std::vector<EffectSpec> as_effect(const YamlNode& node, Mentions& mentions, Diagnostics& say) {
  if constexpr (std::is_invocable_v<decltype(read), const YamlNode&, Diagnostics&>)
    return {read(node, say)};
  else
    return {read(node, mentions, say)};
}

constexpr EffectReader effect_readers[] = {
    {"stretch", as_effect<read_stretch>},   {"bend", as_effect<read_bend>},
    {"gravity", as_effect<read_gravity>},   {"drag", as_effect<read_drag>},
    {"contact", as_effect<read_contact>},   {"contact_damping", as_effect<read_contact_damping>},
    {"friction", as_effect<read_friction>}, {"plates", as_effect<read_plates>},
    {"obstacle", read_obstacles},           {"pressure", as_effect<read_pressure>},
    {"twist", as_effect<read_twist>},       {"knots", as_effect<read_knots>},
};

/// What has no meaning in a fabric without ends, and why.
struct ForSwatches {
  std::string_view key, hint;
};
constexpr ForSwatches effects_for_swatches[] = {
    {"gravity", "leave it out: nothing carries the weight of an endless fabric"},
    {"knots", "leave it out: the yarns of a periodic fabric have no ends"},
    {"obstacle", "leave it out: nothing holds an endless fabric against it"},
    {"pressure", "leave it out: an endless fabric encloses nothing"},
};

void refuse_in_periodic(const Fields& fields, Diagnostics& say) {
  for (const auto& [key, hint] : effects_for_swatches)
    if (const YamlNode* given = fields.find(key))
      say.error("S010", given->span, fmt::format("\"{}\" is for swatches, and this fabric is periodic", key),
                std::string(hint));
}

void refuse_sleep(const YamlNode& solver, Diagnostics& say) {
  if (const YamlNode* sleep = solver.find("sleep"))
    say.error("S010", sleep->span, "\"sleep\" is for swatches, and this fabric is periodic",
              "leave it out: whatever moves in an endless fabric moves in every repeat");
}

/// Those among which a choice is left open, with their defaults, in the order of effect_readers.
std::vector<EffectSpec> candidates(bool periodic) {
  std::vector<EffectSpec> all;
  all.emplace_back(Stretch{});
  all.emplace_back(Bend{});
  if (!periodic) all.emplace_back(Gravity{});
  all.emplace_back(Drag{});
  all.emplace_back(Contact{});
  all.emplace_back(Friction{});
  if (!periodic) all.emplace_back(Knots{});
  return all;
}

void open_choice(Stage& stage, bool periodic) {
  stage.effects_open = true;
  for (EffectSpec& candidate : candidates(periodic)) {
    const auto is_same = [&](const EffectSpec& one) { return one.index() == candidate.index(); };
    if (std::none_of(stage.effects.begin(), stage.effects.end(), is_same))
      stage.effects.push_back(std::move(candidate));
  }
}

}  // namespace

void read_effects(const YamlNode& node, bool periodic, Stage& stage, Mentions& mentions, Diagnostics& say) {
  if (node.kind == YamlNode::Kind::scalar && node.text == "auto") return open_choice(stage, periodic);
  std::vector<EffectSpec>& effects = stage.effects;
  std::vector<std::string_view> keys{"auto"};
  for (const EffectReader& reader : effect_readers) keys.push_back(reader.key);
  const Fields fields(node, "the effects", keys, say);
  if (periodic) refuse_in_periodic(fields, say);
  if (fields.find("auto")) open_choice(stage, periodic);
  for (const EffectReader& reader : effect_readers) {
    const YamlNode* given = fields.find(reader.key);
    if (!given) continue;
    const std::vector<EffectSpec> specs = reader.read(*given, mentions, say);
    const auto is_same = [&](const EffectSpec& one) { return one.index() == specs.front().index(); };
    const auto place = std::find_if(effects.begin(), effects.end(), is_same) - effects.begin();
    effects.erase(std::remove_if(effects.begin(), effects.end(), is_same), effects.end());
    effects.insert(effects.begin() + place, specs.begin(), specs.end());
  }
}

SolverSpec read_solver(const YamlNode& node, bool periodic, Diagnostics& say) {
  std::vector<std::string_view> keys;
  for (const SolverReader& reader : solver_readers) keys.push_back(reader.key);
  const YamlNode defaults;
  const SolverReader* chosen = nullptr;
  const YamlNode* settings = &defaults;
  if (node.kind == YamlNode::Kind::scalar) {
    if (const auto word = read_word(node, "the solver", keys, say)) chosen = &solver_readers[*word];
  } else {
    const Fields fields(node, "the solver", keys, say);
    for (const SolverReader& reader : solver_readers) {
      const YamlNode* given = fields.find(reader.key);
      if (!given) continue;
      if (chosen) say.error("S004", node.entries[1].span, "a stage has one solver", "keep one of them");
      chosen = &reader;
      settings = given;
    }
  }
  if (!chosen) return QuasiStatic{};
  if (periodic) refuse_sleep(*settings, say);
  return chosen->read(*settings, say);
}

}  // namespace wale
