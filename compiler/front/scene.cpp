#include "compiler/front/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/fields.hpp"
#include "compiler/front/limits.hpp"
#include "compiler/front/scene_parts.hpp"

namespace wale {
namespace {

bool is_scene(const YamlNode& root, Diagnostics& say) {
  const YamlNode* version = root.find("scene");
  if (version && version->text == "1") return true;
  const Span start{root.span.source, 0, 0};
  if (version) {
    say.error("S001", version->span, "this scene is of a version that nobody knows", "write `scene: 1`");
  } else if (root.find("knit")) {
    say.error("S001", start, "this is a chart, not a scene",
              "write a scene that names it: `scene: 1`, `fabric: {pattern: ...}`, `effects:` and `stages:`");
  } else {
    say.error("S001", start, "this is not a scene", "begin a scene with `scene: 1`");
  }
  return false;
}

void read_gauge(const YamlNode& node, ParsedScene& scene, Diagnostics& say) {
  const Fields fields(node, "the gauge", {"thickness"}, say);
  const YamlNode* thickness = fields.find("thickness");
  if (!thickness) return;
  const auto value = read_quantity(*thickness, "the thickness", dimensions::length,
                                   {limits::least_diameter, 2 * limits::most_diameter}, say);
  scene.thickness = value.value_or(0);
}

std::optional<ParsedScene> read_scene(const Source& source, Diagnostics& say) {
  const std::size_t errors_before = say.error_count();
  const std::optional<YamlNode> root = parse_yaml(source, say);
  if (!root || !is_scene(*root, say)) return std::nullopt;
  const Fields fields(*root, "a scene", {"scene", "name", "accuracy", "fabric", "gauge", "effects", "stages", "solver"},
                      say);
  ParsedScene scene;
  scene.name = std::filesystem::path(source.name).stem().string();
  if (const YamlNode* name = fields.find("name")) scene.name = read_text(*name, "the name", say).value_or(scene.name);
  if (const YamlNode* accuracy = fields.find("accuracy"))
    if (const auto text = read_text(*accuracy, "the accuracy", say))
      scene.accuracy = read_accuracy(*text, accuracy->span, say);
  if (const YamlNode* fabric = fields.require("fabric", "add `fabric: {pattern: ../patterns/jersey.yaml}`")) {
    read_fabric(*fabric, scene, say);
  }
  if (const YamlNode* gauge = fields.find("gauge")) read_gauge(*gauge, scene, say);
  Stage common;
  if (const YamlNode* effects = fields.find("effects"))
    read_effects(*effects, scene.overrides.periodic, common, scene.mentions, say);
  common.solver_open = !fields.find("solver");
  if (const YamlNode* solver = fields.find("solver"))
    common.solver = read_solver(*solver, scene.overrides.periodic, say);
  const bool curls = scene.curls != Curls::never;
  scene.stages = read_stages(*root, common, scene.overrides.periodic, curls, scene.mentions, say);
  if (say.error_count() > errors_before) return std::nullopt;
  return scene;
}

}  // namespace

std::optional<double> read_accuracy(std::string_view text, Span span, Diagnostics& say) {
  return read_quantity(text, span, "the accuracy", dimensions::ratio, {1e-4, 0.5}, say);
}

std::optional<ParsedScene> parse_scene(const Source& source, Diagnostics& say) {
  const std::size_t before = say.all().size();
  std::optional<ParsedScene> scene = read_scene(source, say);
  say.order_by_place(before);
  return scene;
}

bool suits(const ParsedScene& scene, bool knitout, Diagnostics& say) {
  const std::size_t before = say.all().size(), errors_before = say.error_count();
  for (const PatternKey& key : scene.pattern_keys) {
    if (key.knitout == knitout) continue;
    say.error("S007", key.span,
              fmt::format("{} is for {}, and this pattern is {}", key.what, knitout ? "charts" : "knitout files",
                          knitout ? "a knitout file" : "a chart"),
              std::string(key.hint));
  }
  say.order_by_place(before);
  return say.error_count() == errors_before;
}

const Source* read_pattern(const ParsedScene& scene, Sources& sources, Diagnostics& say) {
  const Source* source = sources.read(scene.pattern_path);
  if (!source) {
    say.error("F001", scene.pattern_span, fmt::format("cannot read \"{}\"", scene.pattern_path),
              "a pattern's path is relative to the folder of the scene");
  }
  return source;
}

}  // namespace wale
