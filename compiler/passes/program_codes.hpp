/// The codes of what the middle of the compiler reports: lowering, needle program, stitch graph, placing.
#pragma once

#include <array>
#include <string_view>

#include "compiler/diagnostic.hpp"

namespace wale::codes {

inline constexpr std::string_view empty_chart = "L001";
inline constexpr std::string_view tube_wales = "L002";
inline constexpr std::string_view not_placeable = "L010";

inline constexpr std::string_view carrier_not_in = "P001";
inline constexpr std::string_view carrier_already_in = "P002";
inline constexpr std::string_view carrier_missing = "P003";
inline constexpr std::string_view carrier_twice = "P004";
inline constexpr std::string_view direction_missing = "P005";
inline constexpr std::string_view not_facing = "P006";
inline constexpr std::string_view same_bed = "P007";
inline constexpr std::string_view slider = "P008";
inline constexpr std::string_view needle_out_of_range = "P009";
inline constexpr std::string_view carrier_left_in = "P020";
inline constexpr std::string_view carrier_unused = "P021";
inline constexpr std::string_view racked_far = "P022";

inline constexpr std::string_view knit_on_empty = "G001";
inline constexpr std::string_view loop_runs = "G002";
inline constexpr std::string_view long_float = "G003";

/// A code, how bad it is, what it means and what to do about it.
struct ProgramCode {
  std::string_view code;
  Severity severity;
  std::string_view meaning, fix;
};

inline constexpr std::array<ProgramCode, 18> program_codes{{
    {empty_chart, Severity::error, "a chart has no stitches", "give it at least one course and one wale"},
    {tube_wales, Severity::error, "a tube has an odd number of wales, or fewer than four",
     "use an even number of wales, at least 4: half of them go on each bed"},
    {not_placeable, Severity::error, "a loop is not pulled through the one loop below it, so it has no place yet",
     "knit every cell of every course, each through the loop below"},
    {carrier_not_in, Severity::error, "a carrier knits or goes out while it is out", "bring it in first"},
    {carrier_already_in, Severity::error, "a carrier is brought in while it is in", "take it out first"},
    {carrier_missing, Severity::error, "an instruction needs a carrier", "name the carrier"},
    {carrier_twice, Severity::error, "an instruction names a carrier twice", "name it once"},
    {direction_missing, Severity::error, "a stitch with yarn has no direction", "write + or - after the operation"},
    {not_facing, Severity::error, "loops go to a needle that does not face theirs", "rack the beds so that F = B + R"},
    {same_bed, Severity::error, "loops go to a needle of the same bed", "move them to the other bed"},
    {slider, Severity::error, "a slider is used, which this version cannot do", "use the needles of the two beds"},
    {needle_out_of_range, Severity::error, "a needle lies farther out than any machine is wide",
     "number the needles from -100000 to 100000"},
    {carrier_left_in, Severity::warning, "a carrier is still in at the end", "take it out after its last stitch"},
    {carrier_unused, Severity::warning, "a carrier is brought in and never knits", "leave it out"},
    {racked_far, Severity::warning, "the beds are racked farther than most machines go", "rack at most 4 needles"},
    {knit_on_empty, Severity::warning, "a loop is knit on an empty needle above the cast-on",
     "tuck if a new loop is meant"},
    {loop_runs, Severity::warning, "a loop holds nothing and nothing holds it: it will run",
     "knit it, or keep it on its needle"},
    {long_float, Severity::warning, "yarn floats past many needles", "tuck it on the way"},
}};

}  // namespace wale::codes
