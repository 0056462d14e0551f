/// After a run: a cheaper solution of the same scene tells how far the first may be off, and whether what was left out
/// was worth leaving out.
#pragma once

#include "sim/run.hpp"
#include "studio/choice/settle.hpp"

namespace wale {

struct SecondLook {
  int segments = 0;               ///< a stitch: two thirds of those of the run
  std::optional<double> error{};  ///< estimated, of the run's stress over its peak; of spacings if nothing was pulled
  bool of_pull_only = false;      ///< friction acted at rest, which depends on how it was reached: that is not in it
  std::string failure{};          ///< why there is no estimate
  double seconds = 0;             ///< wall time of all that it took
  double share_of_run = 0;        ///< those over the run's
};

/// Whether there is something to look for: an accuracy was asked for, or a decision was close.
bool wants_second_look(const Settled&);

/// Begins with the rest that the run found. Sets Decision::seen of those that were close. An error of second order is
/// assumed, which is more than what is mostly seen. Uses `progress` and `interrupt` of the options.
SecondLook look_again(const SceneText&, Settled&, const Results& run, const RunOptions&);

/// A line or two on what was found.
std::string words_of(const SecondLook&, const Settled&);

}  // namespace wale
