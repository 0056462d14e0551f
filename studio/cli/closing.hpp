/// What `wale run` prints when it has run.
#pragma once

#include <string>

#include "sim/run.hpp"

namespace wale {

/// The curve drawn in characters, whether the crossings held, how nearly forces balance, and which file is for what.
std::string closing_words(const Results&, const std::string& folder);

/// Says on stderr if and how a run ended early. Gives the exit code.
int tell_outcome(const Results&, Outcome, const std::string& folder);

}  // namespace wale
