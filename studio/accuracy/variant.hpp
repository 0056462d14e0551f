/// A scene that is run otherwise than its file says.
#pragma once

#include <functional>
#include <string>

#include "compiler/compile.hpp"

namespace wale {

struct Variant {
  FabricChanges changes;                 ///< before it is compiled
  std::function<void(Scene&)> adjust{};  ///< after it is compiled; may be empty
};

/// A scene's file with all that it reads, and how it is compiled in variants.
class SceneText {
 public:
  /// Both must outlive it.
  SceneText(const Source& scene, Sources& sources) : scene_(scene), sources_(sources) {}
  /// Nothing if an error was reported.
  std::optional<Scene> compile(const Variant&, Diagnostics&) const;
  const Source& source() const { return scene_; }

 private:
  const Source& scene_;
  Sources& sources_;
};

}  // namespace wale
