/// The codes of what the middle of the compiler reports: lowering, needle program, stitch graph, placing.
#pragma once

#include <array>
#include <string_view>

#include "compiler/diagnostic.hpp"

namespace wale::codes {

inline constexpr std::string_view empty_chart = "L001";
inline constexpr std::string_view tube_wales = "L002";
inline constexpr std::string_view too_many_yarns = "L003";
inline constexpr std::string_view not_placeable = "L010";
inline constexpr std::string_view entangled = "L011";
inline constexpr std::string_view floats_too_long = "L012";

inline constexpr std::string_view carrier_not_in = "P001";
inline constexpr std::string_view carrier_already_in = "P002";
inline constexpr std::string_view carrier_missing = "P003";
inline constexpr std::string_view carrier_twice = "P004";
inline constexpr std::string_view direction_missing = "P005";
inline constexpr std::string_view not_facing = "P006";
inline constexpr std::string_view same_bed = "P007";
inline constexpr std::string_view slider = "P008";
inline constexpr std::string_view needle_out_of_range = "P009";
inline constexpr std::string_view racking_absurd = "P010";
inline constexpr std::string_view stack_absurd = "P011";
inline constexpr std::string_view too_many_ties = "P012";
inline constexpr std::string_view carrier_left_in = "P020";
inline constexpr std::string_view carrier_unused = "P021";
inline constexpr std::string_view racked_far = "P022";

inline constexpr std::string_view hook_busy = "P023";
inline constexpr std::string_view hook_release = "P024";
inline constexpr std::string_view miss_without_yarn = "P025";

inline constexpr std::string_view knit_on_empty = "G001";
inline constexpr std::string_view loop_runs = "G002";
inline constexpr std::string_view long_float = "G003";
inline constexpr std::string_view loops_left = "G004";
inline constexpr std::string_view stack_high = "G005";
inline constexpr std::string_view column_unravels = "G006";
inline constexpr std::string_view loose_end = "G007";
inline constexpr std::string_view empty_needle = "G008";
inline constexpr std::string_view crop_empty = "G009";

/// A code, how bad it is, what it means, and an example of what to write instead.
struct ProgramCode {
  std::string_view code;
  Severity severity;
  std::string_view meaning, fix;
};

inline constexpr auto program_codes = std::to_array<ProgramCode>({
    {empty_chart, Severity::error, "a chart or a machine's program has no stitches",
     "wales: 12\nbands:\n  - {stitch: jersey, courses: 13}"},
    {tube_wales, Severity::error, "a tube has an odd number of wales, or fewer than four: half of them go on each bed",
     "form: tube\nwales: 20"},
    {too_many_yarns, Severity::error, "a chart has more yarns than the machine has carriers",
     "wale compile chart.yaml -o chart.k --machine swg   # ten carriers; a Kniterate has six"},
    {not_placeable, Severity::error,
     "a loop cannot be drawn yet so that it is pulled through the loops that it should be",
     "wale compile glove.k -o glove.svg --courses 5-30   # leaves the part out that holds it"},
    {entangled, Severity::error,
     "a loop or a float cannot be drawn yet without passing through a loop that it is not knitted with",
     "wale compile glove.k -o glove.svg --courses 5-30   # leaves the part out that holds it"},
    {floats_too_long, Severity::error, "the yarn between the stitches is too long to be drawn",
     "wale compile glove.k -o glove.svg --needles 0-200   # leaves out what lies far away"},
    {carrier_not_in, Severity::error, "a carrier knits, or goes out, while it is out", "in a\nknit + f0 a"},
    {carrier_already_in, Severity::error, "a carrier is brought in while it is in", "in a\nknit + f0 a\nout a\nin a"},
    {carrier_missing, Severity::error, "an instruction names no carrier, and needs one", "in a"},
    {carrier_twice, Severity::error, "an instruction names a carrier twice", "knit + f0 a b ; not a a"},
    {direction_missing, Severity::error, "a stitch with yarn has no direction", "knit + f0 a"},
    {not_facing, Severity::error, "loops go to a needle that does not face theirs: front = back + racking",
     "rack 2\nxfer f3 b1"},
    {same_bed, Severity::error, "loops go to a needle of the same bed", "xfer f3 b3"},
    {slider, Severity::error, "a loop is made on a slider, or goes from slider to slider: sliders only hold loops",
     "xfer f3 bs3\nrack 1\nxfer bs3 f4"},
    {needle_out_of_range, Severity::error, "a needle lies beyond the end of any bed: -100000 to 100000 are allowed",
     "knit + f12 a"},
    {racking_absurd, Severity::error, "the beds are racked farther than any bed is long", "rack 2"},
    {stack_absurd, Severity::error, "a needle would hold more than 100 loops", "knit + f0 a ; before the next tuck"},
    {too_many_ties, Severity::error, "more than four million loops are knitted through or moved",
     "cut the program into several"},
    {carrier_left_in, Severity::warning, "a carrier is still in at the end", "out a ; after its last stitch"},
    {carrier_unused, Severity::warning, "a carrier is brought in and never knits", "in a\nknit + f0 a\nout a"},
    {racked_far, Severity::warning,
     "the beds are racked farther than the machine goes: 8 needles on a Shima SWG, 2 on a Kniterate, 4 if no header "
     "says which",
     "rack 2"},
    {hook_busy, Severity::warning, "the inserting hook is wanted while it still holds another carrier's yarn",
     "inhook 1\ntuck - f2 1\ntuck - f1 1\nreleasehook 1\ninhook 2"},
    {hook_release, Severity::warning,
     "the hook is released while it is empty, holds other carriers, or before the yarn has been stitched",
     "inhook 1\ntuck - f2 1\nreleasehook 1"},
    {miss_without_yarn, Severity::warning, "a miss names no carrier, so nothing moves", "miss + f5 1"},
    {knit_on_empty, Severity::warning, "a loop is knit on an empty needle above the cast-on",
     "tuck + f0 a ; if a new loop is meant"},
    {loop_runs, Severity::warning, "a loop holds nothing and nothing holds it, so it will run",
     "knit + f0 a ; before its needle drops it"},
    {long_float, Severity::warning, "yarn floats past more than 20 needles", "tuck + f10 a ; on the way"},
    {loops_left, Severity::warning, "loops are left on the needles at the end; they stay as a live edge",
     "xfer f1 b1\nxfer b1 f2\nknit + f2 1 ; bind off from the left, or: drop f1"},
    {stack_high, Severity::warning, "a needle holds more loops than a hook takes well: four",
     "knit + f0 1 ; before the next tuck"},
    {column_unravels, Severity::warning, "a live loop is dropped, so that its column unravels",
     "knit + f0 1 ; before: drop f0"},
    {loose_end, Severity::warning, "a carrier goes out after its last loop was dropped, so its yarn's end is loose",
     "out 1\ndrop f0"},
    {empty_needle, Severity::note, "a needle without loops is dropped or transferred, which does nothing",
     "leave the line out"},
    {crop_empty, Severity::error, "no loop lies in the courses and on the needles that are wanted",
     "wale check FILE.k --courses 1-20 --needles 0-39"},
});

}  // namespace wale::codes
