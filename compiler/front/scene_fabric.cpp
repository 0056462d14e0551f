#include <fmt/format.h>

#include <filesystem>

#include "compiler/fields.hpp"
#include "compiler/front/limits.hpp"
#include "compiler/front/materials.hpp"
#include "compiler/front/scene_parts.hpp"
#include "compiler/front/scene_settings.hpp"

namespace wale {
namespace {

constexpr int sound_segments = 10;

std::string beside(const std::string& file, const std::string& path) {
  return (std::filesystem::path(file).parent_path() / path).lexically_normal().string();
}

/// `{otherwise: 9 mm, 6: 9.5 mm}`; faulty entries are reported and left out.
StitchLengths read_table(const YamlNode& node, Diagnostics& say) {
  StitchLengths lengths;
  for (const YamlEntry& entry : node.entries) {
    const auto text = read_text(entry.value, "a stitch length", say);
    const auto length = text ? read_stitch_length(*text, entry.value.span, say) : std::nullopt;
    if (length) add_setting(lengths, entry.key, *length, entry.span, say);
  }
  return lengths;
}

class FabricReader {
 public:
  FabricReader(const YamlNode& node, ParsedScene& scene, Diagnostics& say)
      : fields_(node, "a fabric",
                {"pattern", "crop", "wales", "courses", "periodic", "curl", "yarn", "yarns", "plating", "stitch_length",
                 "segments_per_stitch"},
                say),
        scene_(scene),
        say_(say) {}

  void read(const std::string& scene_file) {
    if (const YamlNode* pattern =
            fields_.require("pattern", "name a chart, as in `pattern: ../patterns/jersey.yaml`")) {
      scene_.pattern_path = beside(scene_file, read_text(*pattern, "a pattern", say_).value_or(""));
      scene_.pattern_span = pattern->span;
    }
    read_size();
    if (const YamlNode* periodic = fields_.find("periodic")) read_periodic(*periodic);
    if (const YamlNode* curl = fields_.find("curl")) read_curl(*curl);
    if (const YamlNode* yarn = fields_.find("yarn"))
      scene_.overrides.materials.otherwise = read_material(*yarn, "yarn", say_);
    if (const YamlNode* yarns = fields_.find("yarns")) read_yarns(*yarns);
    if (const YamlNode* plating = fields_.find("plating")) read_plating(*plating);
    if (const YamlNode* length = fields_.find("stitch_length")) read_lengths(*length);
    if (const YamlNode* segments = fields_.find("segments_per_stitch")) read_segments(*segments);
  }

 private:
  void only_for_charts(std::string_view what, std::string_view hint, const YamlNode& node) {
    scene_.pattern_keys.push_back({false, what, hint, node.span});
  }
  void only_for_knitout(std::string_view what, std::string_view hint, const YamlNode& node) {
    scene_.pattern_keys.push_back({true, what, hint, node.span});
  }

  void read_size() {
    if (const YamlNode* crop = fields_.find("crop")) {
      const Fields part(*crop, "a crop", {"courses", "needles"}, say_);
      scene_.knitout.crop = {read_range(part.find("courses"), say_), read_range(part.find("needles"), say_)};
      only_for_knitout("\"crop\"", "give a chart `wales:` and `courses:`", *crop);
    }
    if (const YamlNode* wales = fields_.find("wales")) {
      scene_.overrides.wales = read_count(*wales, "the number of wales", 1, limits::most_wales, say_);
      only_for_charts("\"wales\"", "keep a part of the file: `crop: {needles: 0-39}`", *wales);
    }
    if (const YamlNode* courses = fields_.find("courses")) {
      scene_.overrides.courses = read_count(*courses, "the number of courses", 1, limits::most_courses, say_);
      only_for_charts("\"courses\"", "keep a part of the file: `crop: {courses: 1-20}`", *courses);
    }
  }

  void read_periodic(const YamlNode& node) {
    scene_.overrides.periodic = read_bool(node, "\"periodic\"", say_).value_or(false);
    if (scene_.overrides.periodic) only_for_charts("\"periodic\"", "leave it out, or draw one repeat as a chart", node);
  }

  void read_curl(const YamlNode& node) {
    const auto word = read_word(node, "\"curl\"", {"never", "about_courses", "about_wales"}, say_);
    scene_.curls = static_cast<Curls>(word.value_or(0));
    if (scene_.curls != Curls::never && !scene_.overrides.periodic)
      say_.error("S010", node.span, "\"curl\" is for periodic fabrics, and this is a swatch",
                 "add `periodic: true`, or leave it out: a swatch curls as it is let");
  }

  void read_yarns(const YamlNode& node) {
    if (node.kind != YamlNode::Kind::map) {
      say_.error("Y004", node.span, "\"yarns\" must be a map from yarns or carriers to materials",
                 "write `yarns: {1: acrylic_16_2}`, or `yarn: acrylic_16_2` for all");
      return;
    }
    for (const YamlEntry& entry : node.entries)
      if (auto material = read_material(entry.value, entry.key, say_))
        scene_.overrides.materials.by_name.push_back({entry.key, std::move(*material), entry.span});
  }

  void read_plating(const YamlNode& node) {
    if (const auto word = read_word(node, "the plating", {plating_words.begin(), plating_words.end()}, say_))
      scene_.knitout.plating = Plating{static_cast<std::uint8_t>(*word)};
    only_for_knitout("\"plating\"", "leave it out: a chart has one yarn in each stitch", node);
  }

  void read_lengths(const YamlNode& node) {
    StitchLengths lengths;
    const bool map = node.kind == YamlNode::Kind::map;
    if (map)
      lengths = read_table(node, say_);
    else if (const auto text = read_text(node, "a stitch length", say_))
      lengths = parse_stitch_lengths(*text, node.span, say_).value_or(lengths);
    if (map || !lengths.by_setting.empty())
      only_for_knitout("a stitch length by setting",
                       "write one length, as in `stitch_length: 7.23 mm`; the chart's bands and yarns have their own",
                       node);
    else if (lengths.otherwise > 0)
      scene_.overrides.stitch_length = lengths.otherwise;
    scene_.knitout.stitch_lengths = std::move(lengths);
  }

  void read_segments(const YamlNode& node) {
    const auto count =
        read_count(node, "the number of segments a stitch", limits::least_segments, limits::most_segments, say_);
    scene_.segments_per_stitch = count.value_or(scene_.segments_per_stitch);
    if (count && *count < sound_segments)
      say_.warning(
          "S006", node.span,
          fmt::format("with {} segments a stitch the spline cuts corners: yarns start as near as a quarter of a "
                      "diameter",
                      *count),
          fmt::format("use {} or more, or expect a first step that pushes hard", sound_segments));
  }

  Fields fields_;
  ParsedScene& scene_;
  Diagnostics& say_;
};

}  // namespace

void read_fabric(const YamlNode& node, ParsedScene& scene, Diagnostics& say) {
  FabricReader(node, scene, say).read(node.span.source->name);
}

}  // namespace wale
