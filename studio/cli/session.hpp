/// A run from its texts: begun anew, or taken up where it stopped.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "sim/results/results.hpp"
#include "studio/choice/settle.hpp"

namespace wale {

/// Sets the number of threads of every parallel library here; 0 leaves what the machine offers.
void use_threads(int count);

/// A run, and the texts and decisions that it comes from.
struct Session {
  std::unique_ptr<Sources> sources;  ///< the scene is the first
  Settled settled;                   ///< less its scene, which is that of the results
  Results results;
  SceneText text() const { return {sources->all().front(), *sources}; }
};

/// Compiles a scene file and decides what it leaves open. What is wrong is told on stderr; nothing then.
std::optional<Session> begin_run(const std::string& scene_path, std::optional<double> accuracy);

/// Reads `results_path`, and compiles the texts stored there again: effects and solvers are not stored but made.
/// What is wrong is told on stderr; nothing then. Throws std::system_error if the file cannot be read.
std::optional<Session> resume_run(const std::string& results_path);

/// Wall time of `work`, s.
double seconds_of(const std::function<void()>& work);

}  // namespace wale
