/// One rest for several resolutions of a scene: a fabric may rest in several ways, and only runs that rest alike tell
/// how far each resolution is off.
#pragma once

#include <optional>

#include "sim/run.hpp"

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

}  // namespace wale
