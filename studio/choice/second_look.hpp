/// After a run: a cheaper solution of the same scene tells how far the first may be off, and whether what was left out
/// was worth leaving out.
#pragma once

#include "sim/run.hpp"
#include "studio/choice/settle.hpp"

namespace wale {

struct SecondLook {
  int segments = 0;               ///< a stitch: two thirds of those of the run; the samples are half of its
  std::optional<double> error{};  ///< estimated, of the run's stress over its peak; of spacings if nothing was pulled
  bool of_pull_only = false;      ///< friction acted at rest, which depends on how it was reached: that is not in it
  std::string failure{};          ///< why there is no estimate
  double seconds = 0;             ///< wall time of all that it took
  double share_of_run = 0;        ///< those over the run's
};

/// Whether there is something to look for: an accuracy was asked for, or a decision was close.
bool wants_second_look(const Settled&);

/// Begins with the rest that the run found. The error is taken to be no more than the two differ by. Sets
/// Decision::seen of those that were close. Uses `progress` and `interrupt` of the options.
SecondLook look_again(const SceneText&, Settled&, const Results& run, const RunOptions&);

/// Whether an accuracy was asked for and the estimate is not below it, or cannot be told.
bool is_too_far_off(const SecondLook&, const Settled&);

/// A line or two on what was found.
std::string findings(const SecondLook&, const Settled&);

}  // namespace wale
