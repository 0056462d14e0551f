#include <fmt/format.h>

#include <algorithm>

#include "compiler/fields.hpp"
#include "compiler/front/scene_parts.hpp"
#include "compiler/front/scene_settings.hpp"
#include "sim/deform.hpp"

namespace wale {
namespace {

constexpr std::string_view example_stages =
    "add `stages:` with a line for each, as in `- {name: tighten, duration: 1 s, tighten: 100 %, hold: ends}`, "
    "`- {name: relax, duration: 1 s}`, `- {name: pull, duration: 8 s, pull: {along: wale, to: 60 %}}`";
constexpr int most_samples = 100'000;

class StageReader {
 public:
  StageReader(const YamlNode& node, Stage common, bool periodic, bool curls, Mentions& mentions, Diagnostics& say)
      : node_(node),
        fields_(node, "a stage",
                {"name", "duration", "samples", "tighten", "shrink", "hold", "mount", "pull", "deform",
                 "grip_stiffness", "effects", "solver"},
                say),
        stage_(std::move(common)),
        periodic_(periodic),
        curls_(curls),
        mentions_(mentions),
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
    if (const YamlNode* shrink = fields_.find("shrink")) stage_.shrink = read_shrink(*shrink, mentions_, say_);
    if (const YamlNode* hold = fields_.find("hold")) {
      const auto word = read_word(*hold, "\"hold\"", {"none", "ends", "periods"}, say_);
      stage_.hold = static_cast<Hold>(word.value_or(0));
    }
    if (const YamlNode* mount = fields_.find("mount")) {
      const auto word = read_word(*mount, "\"mount\"", {"wale", "course"}, say_);
      stage_.mount = word.value_or(0) == 0 ? Along::wale : Along::course;
    }
    if (const YamlNode* pull = fields_.find("pull")) stage_.pull = read_pull(*pull, periodic_, say_);
    if (const YamlNode* deform = fields_.find("deform")) stage_.deform = read_deform(*deform, say_);
    if (const YamlNode* grip = fields_.find("grip_stiffness")) {
      const auto value = read_quantity(*grip, "the grip stiffness", dimensions::foundation, {1e-6, 1e12}, say_);
      stage_.grip_stiffness = value.value_or(stage_.grip_stiffness);
    }
    if (const YamlNode* effects = fields_.find("effects")) read_effects(*effects, periodic_, stage_, mentions_, say_);
    for (EffectSpec& effect : stage_.effects) last(stage_.duration, effect);
    if (const YamlNode* solver = fields_.find("solver")) {
      stage_.solver = read_solver(*solver, periodic_, say_);
      stage_.solver_open = false;
    }
    check_sense();
    check_suits_fabric();
    return stage_;
  }

 private:
  /// Effects are read with the stage as their unit of time.
  static void last(double duration, EffectSpec& effect) {
    std::visit(
        [&](auto& spec) {
          if constexpr (requires { spec.progress; }) spec.progress = spec.progress.over(duration);
        },
        effect);
  }

  void check_sense() {
    if (stage_.effects.empty() && !fields_.find("effects")) {
      say_.error("S005", {node_.span.source, node_.span.begin, node_.span.begin},
                 "nothing acts on the yarns in this stage",
                 "add `effects: {stretch: , bend: , contact: }` to the scene: what is not named is not simulated");
    }
    if (stage_.pull)
      exclude({"tighten", "hold", "mount", "deform"}, "pull", "a pull grips the ends, or drives a period, by itself");
    if (stage_.deform) exclude({"hold", "mount"}, "deform", "`held` in `deform` keeps a period as it is");
    if (stage_.deform && drives(*stage_.deform)) exclude({"tighten"}, "deform", "first tighten, then deform");
  }

  void exclude(const std::vector<std::string_view>& keys, std::string_view other, std::string_view why) {
    for (const std::string_view key : keys) {
      const YamlNode* given = fields_.find(key);
      if (!given || given->text == "none") continue;
      say_.error("S004", given->span, fmt::format("a stage cannot {} and \"{}\" at once", other, key),
                 fmt::format("make two stages of it; {}", why));
    }
  }

  static bool drives(const Deform& deform) {
    const auto driven = [](const Deform::Part& part) { return part.how == Deform::How::driven; };
    return driven(deform.wale) || driven(deform.course) || driven(deform.shear) || driven(deform.curl);
  }

  void check_suits_fabric() {
    if (!periodic_) {
      refuse("deform", "write `pull: {along: wale, to: 60 %}`, or `periodic: true` in `fabric`");
      if (stage_.hold == Hold::periods) refuse("hold", "write `hold: ends`, or `periodic: true` in `fabric`");
      return;
    }
    if (stage_.hold == Hold::ends)
      refuse("hold", "leave it out, so that the repeat shrinks with its yarn, or write `hold: periods`");
    refuse("mount", "leave it out: a stage without a pull lets both periods go where they carry no force");
    refuse("grip_stiffness", "leave it out: periods are not gripped");
    check_suits_curl();
  }

  void check_suits_curl() {
    const YamlNode* deform = fields_.find("deform");
    const YamlNode* curl = deform ? deform->find("curl") : nullptr;
    if (curl && !curls_)
      say_.error("S010", curl->span, "this fabric is flat, and has no curl",
                 "write `curl: about_courses` in `fabric`, or leave it out");
    if (!curls_) return;
    if (acts<Plates>())
      refuse_curled("plates keep a fabric flat, and this one may curl", "leave out `plates`, or `curl`");
    if (acts<Drag>())
      refuse_curled("drag is against the flow of flat periods, and this fabric may curl",
                    "leave out `drag`, or `curl`");
    if (stage_.follows_motion())
      refuse_curled("a fabric that may curl goes from equilibrium to equilibrium only",
                    "write `solver: quasi_static`, or leave out `curl`");
  }

  template <class E>
  bool acts() const {
    return std::any_of(stage_.effects.begin(), stage_.effects.end(),
                       [](const EffectSpec& effect) { return std::holds_alternative<E>(effect); });
  }

  void refuse_curled(std::string_view what, std::string_view hint) {
    say_.error("S010", {node_.span.source, node_.span.begin, node_.span.begin}, std::string(what), std::string(hint));
  }

  void refuse(std::string_view key, std::string_view hint) {
    const YamlNode* given = fields_.find(key);
    if (!given) return;
    const std::string_view for_swatches = "is for swatches, and this fabric is periodic",
                           for_periodic = "is for periodic fabrics, and this is a swatch";
    const std::string what = key == "hold" ? fmt::format("\"hold: {}\"", given->text) : fmt::format("\"{}\"", key);
    say_.error("S010", given->span, fmt::format("{} {}", what, periodic_ ? for_swatches : for_periodic),
               std::string(hint));
  }

  const YamlNode& node_;
  Fields fields_;
  Stage stage_;
  bool periodic_, curls_;
  Mentions& mentions_;
  Diagnostics& say_;
};

}  // namespace

std::vector<Shrink> read_shrink(const YamlNode& node, Mentions& mentions, Diagnostics& say) {
  const auto read = [&](const YamlNode& item) {
    Shrink spec;
    const Settings settings(item, "\"shrink\"", {"yarn", "by"}, say);
    settings.require("by", "add how much shorter it wants to be at the end of the stage, as in `by: 20 %`");
    settings.yarns("yarn", mentions, spec.materials);
    settings.quantity("by", dimensions::ratio, {-1, 0.9}, spec.by);
    return spec;
  };
  if (node.kind != YamlNode::Kind::list) return {read(node)};
  std::vector<Shrink> all;
  for (const YamlNode& item : node.items) all.push_back(read(item));
  return all;
}

std::vector<Stage> read_stages(const YamlNode& root, const Stage& common, bool periodic, bool curls, Mentions& mentions,
                               Diagnostics& say) {
  const YamlNode* node = root.find("stages");
  const Span start{root.span.source, root.span.begin, root.span.begin};
  if (!node || node->kind != YamlNode::Kind::list || node->items.empty()) {
    say.error("S002", node ? node->span : start, "this scene has no stages, so nothing would happen",
              std::string(example_stages));
    return {};
  }
  std::vector<Stage> stages;
  for (const YamlNode& item : node->items)
    stages.push_back(StageReader(item, common, periodic, curls, mentions, say).read());
  return stages;
}

}  // namespace wale
