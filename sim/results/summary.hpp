/// A run in one JSON object, for scripts; its members are listed in docs/results.md.
#pragma once

#include <string>

#include "sim/results/results.hpp"

namespace wale {

/// Indented JSON, ending with a new line. What is not known is null.
std::string summary_json(const Results&);

/// summary_json() as a file. Throws std::system_error with the path.
void write_summary(const Results&, const std::string& path);

}  // namespace wale
