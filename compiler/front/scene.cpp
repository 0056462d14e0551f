#include "compiler/front/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/fields.hpp"
#include "compiler/front/limits.hpp"
#include "compiler/front/materials.hpp"
#include "compiler/front/scene_parts.hpp"

namespace wale {
namespace {

constexpr int least_segments = 8, sound_segments = 10, most_segments = 200;

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

std::string beside(const std::string& file, const std::string& path) {
  return (std::filesystem::path(file).parent_path() / path).lexically_normal().string();
}

std::optional<IntRange> read_range(const YamlNode* node, Diagnostics& say) {
  if (!node) return std::nullopt;
  const auto range = parse_range(node->text);
  if (!range)
    say.error("Y007", node->span, fmt::format("\"{}\" is not a range", node->text),
              "write the first and the last, as in 5-20");
  return range;
}

void read_fabric(const YamlNode& node, ParsedScene& scene, Diagnostics& say) {
  const Fields fields(node, "a fabric",
                      {"pattern", "crop", "wales", "courses", "yarn", "stitch_length", "segments_per_stitch"}, say);
  if (const YamlNode* pattern = fields.require("pattern", "name a chart, as in `pattern: ../patterns/jersey.yaml`")) {
    scene.pattern_path = beside(node.span.source->name, read_text(*pattern, "a pattern", say).value_or(""));
    scene.pattern_span = pattern->span;
  }
  if (const YamlNode* crop = fields.find("crop")) {
    const Fields part(*crop, "a crop", {"courses", "needles"}, say);
    scene.crop = {read_range(part.find("courses"), say), read_range(part.find("needles"), say)};
  }
  if (const YamlNode* wales = fields.find("wales")) {
    scene.overrides.wales = read_count(*wales, "the number of wales", 1, limits::most_wales, say);
  }
  if (const YamlNode* courses = fields.find("courses")) {
    scene.overrides.courses = read_count(*courses, "the number of courses", 1, limits::most_courses, say);
  }
  if (const YamlNode* yarn = fields.find("yarn")) scene.overrides.material = read_material(*yarn, "yarn", say);
  if (const YamlNode* length = fields.find("stitch_length")) {
    scene.overrides.stitch_length = read_quantity(*length, "a stitch length", dimensions::length,
                                                  {limits::least_stitch_length, limits::most_stitch_length}, say);
  }
  if (const YamlNode* segments = fields.find("segments_per_stitch")) {
    const auto count = read_count(*segments, "the number of segments a stitch", least_segments, most_segments, say);
    scene.segments_per_stitch = count.value_or(scene.segments_per_stitch);
    if (count && *count < sound_segments)
      say.warning(
          "S006", segments->span,
          fmt::format("with {} segments a stitch the spline cuts corners: yarns start as near as a quarter of a "
                      "diameter",
                      *count),
          fmt::format("use {} or more, or expect a first step that pushes hard", sound_segments));
  }
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
  const Fields fields(*root, "a scene", {"scene", "name", "fabric", "gauge", "effects", "stages", "solver"}, say);
  ParsedScene scene;
  scene.name = std::filesystem::path(source.name).stem().string();
  if (const YamlNode* name = fields.find("name")) scene.name = read_text(*name, "the name", say).value_or(scene.name);
  if (const YamlNode* fabric = fields.require("fabric", "add `fabric: {pattern: ../patterns/jersey.yaml}`")) {
    read_fabric(*fabric, scene, say);
  }
  if (const YamlNode* gauge = fields.find("gauge")) read_gauge(*gauge, scene, say);
  Stage common;
  if (const YamlNode* effects = fields.find("effects")) read_effects(*effects, common.effects, say);
  if (const YamlNode* solver = fields.find("solver")) common.solver = read_solver(*solver, say);
  scene.stages = read_stages(*root, common, say);
  if (say.error_count() > errors_before) return std::nullopt;
  return scene;
}

}  // namespace

std::optional<ParsedScene> parse_scene(const Source& source, Diagnostics& say) {
  const std::size_t before = say.all().size();
  std::optional<ParsedScene> scene = read_scene(source, say);
  say.order_by_place(before);
  return scene;
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
