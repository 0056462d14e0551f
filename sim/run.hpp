/// Runs a scene stage by stage and gathers what it shows.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "sim/results/results.hpp"

namespace wale {

struct RunStatus {
  std::string stage;
  int stage_index = 0, stages = 0;
  double fraction = 0;             ///< of this stage, 0 ... 1
  std::optional<double> residual;  ///< Solver::residual() after this step, N
  const Results* results = nullptr;
};

/// Where a run begins that does not begin with the fabric as compiled.
struct Beginning {
  int stage = 0;
  State state;  ///< of the scene's fabric
};

struct RunOptions {
  std::function<void(const RunStatus&)> progress{};  ///< after every accepted step; may be empty
  std::function<void(const Results&)> save{};        ///< after every sample; may be empty
  const std::atomic<bool>* interrupt = nullptr;      ///< set to stop at the next accepted step
  std::optional<Beginning> begin{};                  ///< of results without snapshots
};

enum class Outcome { finished, interrupted, failed };

/// Goes on from the last snapshot of `results` (if there is none, from `begin`, or from the compiled fabric) to the
/// scene's end.
Outcome run(Results& results, const RunOptions&);

}  // namespace wale
