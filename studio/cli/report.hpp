/// Diagnostics and graphs, as the command line shows them.
#pragma once

#include <nlohmann/json.hpp>

#include "compiler/compile.hpp"

namespace wale {

/// To stderr, in the order reported, each once.
void print_all(const Diagnostics&);

std::string_view name_of(Severity);

/// Indented, with a new line at the end; bytes that are not UTF-8, which a user's text may have, are replaced.
std::string dump(const nlohmann::ordered_json&);

/// `[{severity, code, file, line, column, message, hint}]`
nlohmann::ordered_json to_json(const Diagnostics&);

/// Counts of what was knitted: instructions, loops, edges, knits, what is left on the needles, ... Every loop is
/// counted as one of knits, tucks, splits and knits on empty needles.
nlohmann::ordered_json counts(const Program&, const StitchGraph&);

/// `[{id, carrier, direction, needle, line, op, parents, previous}]`, ids in the order made.
nlohmann::ordered_json loops_json(const Program&, const StitchGraph&);

}  // namespace wale
