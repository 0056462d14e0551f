#include "studio/accuracy/variant.hpp"

namespace wale {

std::optional<Scene> SceneText::compile(const Variant& variant, Diagnostics& say) const {
  auto scene = compile_scene(scene_, sources_, say, variant.changes);
  if (scene && variant.adjust) variant.adjust(*scene);
  return scene;
}

}  // namespace wale
