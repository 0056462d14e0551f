/// A scene with all that it leaves open decided: settings for an accuracy, and which effects it calls for.
#pragma once

#include "studio/choice/decisions.hpp"
#include "studio/choice/resolution.hpp"

namespace wale {

struct Settled {
  Scene scene{};
  double accuracy = 0.01;                ///< asked for, or that by which effects are decided
  std::optional<Resolution> resolution;  ///< if an accuracy is asked for
  int segments_written = 0, segments = 0;
  Scales scales;  ///< of the scene as written, by which all is decided
  std::vector<Decision> decisions;
};

/// Whether there was anything to decide.
inline bool leaves_open(const Settled& settled) { return settled.resolution || !settled.decisions.empty(); }

/// Compiles a scene and decides. `accuracy` goes before the scene's own, and its settings are refined() so many times.
/// Nothing if an error was reported.
std::optional<Settled> settle(const SceneText&, std::optional<double> accuracy, Diagnostics&, int refinements = 0);

/// The same scene in other segments, all decisions alike.
std::optional<Scene> in_other_segments(const SceneText&, const Settled&, int segments_per_stitch);

}  // namespace wale
