#include <array>

#include "compiler/front/scene_parts.hpp"
#include "compiler/front/scene_settings.hpp"

namespace wale {
namespace {

constexpr Range places{-10, 10}, radii{1e-6, 10}, directions{-1e6, 1e6};
constexpr std::string_view example = "{sphere: {centre: [0 mm, 0 mm, -8 mm], radius: 5 mm}}";

/// A direction of length 1; keeps what is there if none is given.
void read_direction(const Settings& settings, std::string_view key, Diagnostics& say, Vec3& direction) {
  const YamlNode* given = settings.find(key);
  Vec3 any = direction;
  settings.vector(key, "a direction", dimensions::ratio, directions, "write it as in `[0, 0, 1]`", any);
  if (any.norm() > 0) {
    direction = any.normalized();
  } else if (given) {
    say.error("Y004", given->span, "this direction points nowhere", "write it as in `[0, 0, 1]`");
  }
}

void read_place(const Settings& settings, std::string_view key, Vec3& place) {
  settings.vector(key, "a place", dimensions::length, places, "write it as in `[0 mm, 0 mm, -8 mm]`", place);
}

/// Which body it is, and where.
void read_body(const YamlNode& node, Obstacle::Shape shape, Diagnostics& say, Obstacle& spec) {
  spec.shape = shape;
  if (shape == Obstacle::Shape::plane) {
    const Settings settings(node, "a plane", {"point", "normal"}, say);
    read_place(settings, "point", spec.centre);
    read_direction(settings, "normal", say, spec.axis);
    return;
  }
  const bool is_round = shape == Obstacle::Shape::sphere;
  const std::vector<std::string_view> known = is_round ? std::vector<std::string_view>{"centre", "radius"}
                                                       : std::vector<std::string_view>{"centre", "axis", "radius"};
  const Settings settings(node, is_round ? "a sphere" : "a cylinder", known, say);
  settings.require("radius", "add it, as in `radius: 5 mm`");
  settings.quantity("radius", dimensions::length, radii, spec.radius);
  read_place(settings, "centre", spec.centre);
  if (is_round) return;
  spec.axis = Vec3::UnitX();
  read_direction(settings, "axis", say, spec.axis);
}

Obstacle read_obstacle(const YamlNode& node, Mentions& mentions, Diagnostics& say) {
  constexpr std::array<std::string_view, 3> shapes{"plane", "cylinder", "sphere"};
  Obstacle spec;
  const std::size_t errors = say.error_count();
  const Settings settings(node, "an obstacle", {"plane", "cylinder", "sphere", "move", "stiffness", "on"}, say);
  const YamlNode* body = nullptr;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const YamlNode* given = settings.find(shapes[i]);
    if (!given) continue;
    if (body)
      say.error("Y004", given->span, "an obstacle is one body", "write a list for several: `obstacle: [{...}, {...}]`");
    body = given;
    read_body(*given, static_cast<Obstacle::Shape>(i), say, spec);
  }
  if (!body && say.error_count() == errors)
    say.error("Y005", node.span, "an obstacle needs a body: a plane, a cylinder or a sphere",
              fmt::format("write `obstacle: {}`", example));
  settings.vector("move", "a move", dimensions::length, places, "write it as in `[0 mm, 0 mm, 4 mm]`", spec.move);
  settings.quantity("stiffness", dimensions::foundation, {1e-6, 1e12}, spec.stiffness);
  settings.part("on", mentions, spec.on);
  spec.progress = Schedule::ramp(0, 1, 1);
  return spec;
}

}  // namespace

std::vector<EffectSpec> read_obstacles(const YamlNode& node, Mentions& mentions, Diagnostics& say) {
  if (node.kind != YamlNode::Kind::list) return {read_obstacle(node, mentions, say)};
  std::vector<EffectSpec> specs;
  for (const YamlNode& item : node.items) {
    Obstacle spec = read_obstacle(item, mentions, say);
    spec.label = fmt::format("obstacle.{}", specs.size() + 1);
    specs.emplace_back(std::move(spec));
  }
  if (specs.empty()) {
    say.error("Y004", node.span, "this list of obstacles is empty", fmt::format("write `obstacle: {}`", example));
    specs.emplace_back(Obstacle{});
  }
  return specs;
}

}  // namespace wale
