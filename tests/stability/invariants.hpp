/// What must hold of every run, however hard.
#pragma once

#include <optional>
#include <string>

#include "sim/results/results.hpp"
#include "tests/stability/hard_case.hpp"

namespace wale::stability {

/// The first thing that is wrong with what a run of the scene has left so far, in words; nothing if all is well:
/// numbers are finite, no yarn has passed another, energy has not grown where nothing does work, and momentum and
/// angular momentum are kept where nothing acts from outside. Looks at every saved state.
std::optional<std::string> what_broke(const HardScene&, const Results&);

}  // namespace wale::stability
