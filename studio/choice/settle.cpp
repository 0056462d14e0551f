#include "studio/choice/settle.hpp"

#include "compiler/front/scene.hpp"
#include "studio/accuracy/adjust.hpp"

namespace wale {
namespace {

double strain_a_sample(const Scene& scene) {
  const Stage* strained = last_strained_stage(scene);
  return strained ? strain_path(*strained) / strained->samples : 0;
}

}  // namespace

std::optional<Settled> settle(const SceneText& text, std::optional<double> accuracy, Diagnostics& say,
                              int refinements) {
  auto scene = text.compile({}, say);
  if (!scene || say.failed()) return std::nullopt;
  Diagnostics said_before;
  Settled settled;
  settled.segments_written = settled.segments = parse_scene(text.source(), said_before)->segments_per_stitch;
  settled.scales = scales_of(scene->fabric, settled.segments_written);
  const std::optional<double> asked = accuracy ? accuracy : scene->accuracy;
  settled.accuracy = asked.value_or(settled.accuracy);
  if (asked) {
    settled.resolution = choose_resolution(*asked, settled.scales, strain_a_sample(*scene));
    for (int i = 0; i < refinements; ++i) settled.resolution = refined(*settled.resolution);
    settled.segments = settled.resolution->segments_per_stitch;
    scene = text.compile(variant_of(*settled.resolution), said_before);
    if (!scene) return std::nullopt;
  }
  settled.decisions = decide_effects(*scene, settled.scales, settled.accuracy);
  settled.scene = std::move(*scene);
  return settled;
}

std::optional<Scene> in_other_segments(const SceneText& text, const Settled& settled, int segments_per_stitch) {
  Variant variant = settled.resolution ? variant_of(*settled.resolution) : Variant{};
  variant.changes.segments_per_stitch = segments_per_stitch;
  Diagnostics said_before;
  auto scene = text.compile(variant, said_before);
  if (scene) decide_effects(*scene, settled.scales, settled.accuracy);
  return scene;
}

}  // namespace wale
