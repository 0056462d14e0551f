/// A run from its texts: begun anew, or taken up where it stopped.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "sim/results/results.hpp"

namespace wale {

/// Sets the number of threads of every parallel library here; 0 leaves what the machine offers.
void use_threads(int count);

/// Compiles a scene file. What is wrong is told on stderr; nothing then.
std::optional<Results> begin_run(const std::string& scene_path);

/// Reads `results_path`, and compiles the texts stored there again: effects and solvers are not stored but made.
/// What is wrong is told on stderr; nothing then. Throws std::system_error if the file cannot be read.
std::optional<Results> resume_run(const std::string& results_path);

/// Wall time of `work`, s.
double seconds_of(const std::function<void()>& work);

}  // namespace wale
