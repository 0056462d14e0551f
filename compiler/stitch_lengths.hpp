/// From a machine's stitch settings to yarn lengths: a program says how far cams pull, not how much yarn a loop takes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "compiler/diagnostic.hpp"
#include "compiler/program.hpp"

namespace wale {

/// Yarn length of a loop, m, by the setting at which it is made: `5` for `x-stitch-number 5`, `25/40` for
/// `stitch 25 40`.
struct StitchLengths {
  double otherwise = 0;  ///< for settings that are not listed; 0: not known
  std::map<std::string, double, std::less<>> by_setting;

  double at(std::string_view setting) const;
};

/// What is assumed where nothing is given. A loop of the middle setting takes three needle pitches of yarn: a relaxed
/// jersey, whose wales stand l / 4.2 apart (Munden), is then 0.71 times as wide as it lay on the needles. On a
/// Kniterate each step from the middle number 5 adds 6 % of that; the numbers of a Shima are places in a table that its
/// operator fills, and say nothing. The gauge is the header's, or else 7 for a Kniterate and 15 for a Shima SWG.
StitchLengths default_stitch_lengths(const Program&);

/// `given` where it says something, else `assumed`; a given length for all other settings replaces all assumed ones.
StitchLengths merged(const StitchLengths& given, const StitchLengths& assumed);

/// "9 mm" for all loops, or by setting: "5 = 9 mm, 6 = 9.5 mm"; both together with the length for the others first.
/// What is wrong is told at its own place if `text` stands as it is in `span`.
std::optional<StitchLengths> parse_stitch_lengths(std::string_view text, Span span, Diagnostics&);

/// Adds a length in m; `otherwise` stands for all settings that are not listed. False, and an error at `place`, if no
/// program has such a setting.
bool add_setting(StitchLengths&, std::string_view setting, double length, Span place, Diagnostics&);

/// The length of one stitch as text, within sensible limits.
std::optional<double> read_stitch_length(std::string_view text, Span, Diagnostics&);

}  // namespace wale
