#include <fmt/format.h>

#include "compiler/fields.hpp"
#include "compiler/front/scene_parts.hpp"

namespace wale {
namespace {

constexpr std::string_view example_stages =
    "add `stages:` with a line for each, as in `- {name: tighten, duration: 1 s, tighten: 100 %, hold: ends}`, "
    "`- {name: relax, duration: 1 s}`, `- {name: pull, duration: 8 s, pull: {along: wale, to: 60 %}}`";
constexpr std::string_view example_pull =
    "say along what: `pull: {along: wale, to: 60 %}` or `{along: course, to: 60 %}`";

constexpr int most_samples = 100'000;

class StageReader {
 public:
  StageReader(const YamlNode& node, Stage common, Diagnostics& say)
      : node_(node),
        fields_(
            node, "a stage",
            {"name", "duration", "samples", "tighten", "hold", "mount", "pull", "grip_stiffness", "effects", "solver"},
            say),
        stage_(std::move(common)),
        say_(say) {}

  Stage read() {
    if (!fields_.is_map()) return stage_;
    if (const YamlNode* name = fields_.find("name"))
      stage_.name = read_text(*name, "a stage's name", say_).value_or("");
    if (const YamlNode* time = fields_.require("duration", "add how long it takes, as in `duration: 1 s`")) {
      stage_.duration = read_quantity(*time, "the duration", dimensions::time, {1e-9, 1e6}, say_).value_or(1);
    }
    if (const YamlNode* samples = fields_.find("samples")) {
      stage_.samples = read_count(*samples, "the number of samples", 1, most_samples, say_).value_or(1);
    }
    if (const YamlNode* tighten = fields_.find("tighten")) {
      stage_.tighten = read_quantity(*tighten, "\"tighten\"", dimensions::ratio, {0, 1}, say_);
    }
    if (const YamlNode* hold = fields_.find("hold")) {
      const auto word = read_word(*hold, "\"hold\"", {"none", "ends"}, say_);
      stage_.hold = word.value_or(0) == 1 ? Hold::ends : Hold::none;
    }
    if (const YamlNode* mount = fields_.find("mount")) {
      const auto word = read_word(*mount, "\"mount\"", {"wale", "course"}, say_);
      stage_.mount = word.value_or(0) == 0 ? Along::wale : Along::course;
    }
    if (const YamlNode* pull = fields_.find("pull")) read_pull(*pull);
    if (const YamlNode* grip = fields_.find("grip_stiffness")) {
      const auto value = read_quantity(*grip, "the grip stiffness", dimensions::foundation, {1e-6, 1e12}, say_);
      stage_.grip_stiffness = value.value_or(stage_.grip_stiffness);
    }
    if (const YamlNode* effects = fields_.find("effects")) read_effects(*effects, stage_.effects, say_);
    if (const YamlNode* solver = fields_.find("solver")) stage_.solver = read_solver(*solver, say_);
    check_sense();
    return stage_;
  }

 private:
  void read_pull(const YamlNode& node) {
    if (node.kind == YamlNode::Kind::scalar) {
      say_.error("S003", node.span, fmt::format("a strain of \"{}\" has no direction", node.text),
                 std::string(example_pull));
      return;
    }
    const Fields pull(node, "a pull", {"along", "to"}, say_);
    if (!pull.is_map()) return;
    Pull spec;
    if (const YamlNode* along = pull.find("along")) {
      const auto word = read_word(*along, "the direction of a pull", {"wale", "course"}, say_);
      spec.along = word.value_or(0) == 0 ? Along::wale : Along::course;
    } else {
      say_.error("S003", node.span, "this strain has no direction", std::string(example_pull));
    }
    if (const YamlNode* to = pull.require("to", "add the strain to reach, as in `to: 60 %`")) {
      spec.strain = read_quantity(*to, "the strain", dimensions::ratio, {1e-6, 20}, say_).value_or(spec.strain);
    }
    stage_.pull = spec;
  }

  void check_sense() {
    if (stage_.effects.empty() && !fields_.find("effects")) {
      say_.error("S005", {node_.span.source, node_.span.begin, node_.span.begin},
                 "nothing acts on the yarns in this stage",
                 "add `effects: {stretch: , bend: , contact: }` to the scene: what is not named is not simulated");
    }
    if (!stage_.pull) return;
    for (const std::string_view key : {"tighten", "hold", "mount"}) {
      const YamlNode* given = fields_.find(key);
      if (!given || given->text == "none") continue;
      say_.error("S004", given->span, fmt::format("a stage cannot pull and \"{}\" at once", key),
                 "make two stages of it; a pull grips the ends by itself");
    }
  }

  const YamlNode& node_;
  Fields fields_;
  Stage stage_;
  Diagnostics& say_;
};

}  // namespace

std::vector<Stage> read_stages(const YamlNode& root, const Stage& common, Diagnostics& say) {
  const YamlNode* node = root.find("stages");
  const Span start{root.span.source, root.span.begin, root.span.begin};
  if (!node || node->kind != YamlNode::Kind::list || node->items.empty()) {
    say.error("S002", node ? node->span : start, "this scene has no stages, so nothing would happen",
              std::string(example_stages));
    return {};
  }
  std::vector<Stage> stages;
  for (const YamlNode& item : node->items) stages.push_back(StageReader(item, common, say).read());
  return stages;
}

}  // namespace wale
