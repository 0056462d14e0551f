/// One rest for several resolutions of a scene: a fabric may rest in several ways, and only runs that rest alike tell
/// how far each resolution is off.
#pragma once

#include <optional>
#include <string>

#include "sim/run.hpp"
#include "studio/accuracy/measured.hpp"

namespace wale {

/// How a fabric lay when it had come to rest.
struct Rest {
  Fabric fabric;
  Points q;           ///< as State::q
  bool rubs = false;  ///< friction acted: then it depends on how it was reached
};

/// The end of the stage before the first that grips, if that stage only waits: it neither tightens nor shrinks.
std::optional<Rest> rest_of(const Results&);

/// Lets a scene begin in the stage where it comes to rest, lying as `rest` does; in the one after it, if friction acts
/// there. Nothing if it has no such stage, or is not the same fabric but for its segments.
std::optional<Beginning> begin_at(const Rest& rest, const Scene&);

/// What a run gave.
struct Found {
  std::optional<Measured> measured;  ///< nothing if it did not get to its end
  std::string failure;               ///< then why
};

/// Runs a scene that begins at `rest` as begin_at() says; as compiled if there is none.
Found run_from(const std::optional<Rest>& rest, const Scene&, RunOptions = {});

}  // namespace wale
