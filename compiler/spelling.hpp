/// "Did you mean": the known word nearest to the one that was written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wale {

/// Insertions, deletions, changes and swaps of neighbours that turn one word into the other; case is ignored.
int edit_distance(std::string_view a, std::string_view b);

/// The nearest of `known`, if at most a third of the letters differ (one letter in short words, but never all); else
/// empty.
std::string_view nearest(std::string_view written, const std::vector<std::string_view>& known);

/// `did you mean "wales"?`, or, with nothing near, `known are a, b, c`.
std::string suggest(std::string_view written, const std::vector<std::string_view>& known);

}  // namespace wale
