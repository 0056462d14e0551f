/// The codes of what the reader of knitout files reports.
#pragma once

#include <array>
#include <string_view>

#include "compiler/passes/program_codes.hpp"

namespace wale::codes {

inline constexpr std::string_view not_knitout = "K001";
inline constexpr std::string_view newer_version = "K002";
inline constexpr std::string_view no_carriers_header = "K003";
inline constexpr std::string_view no_header = "K004";
inline constexpr std::string_view unknown_header = "K005";
inline constexpr std::string_view header_twice = "K006";
inline constexpr std::string_view header_value = "K007";
inline constexpr std::string_view not_plain_text = "K008";
inline constexpr std::string_view nul_byte = "K009";
inline constexpr std::string_view not_a_needle = "K010";
inline constexpr std::string_view unknown_operation = "K011";
inline constexpr std::string_view operand_missing = "K012";
inline constexpr std::string_view operand_extra = "K013";
inline constexpr std::string_view not_a_direction = "K014";
inline constexpr std::string_view not_a_number = "K015";
inline constexpr std::string_view carrier_undeclared = "K016";
inline constexpr std::string_view carriers_header = "K017";
inline constexpr std::string_view program_too_long = "K018";
inline constexpr std::string_view extension_passed_over = "K020";

inline constexpr auto knitout_codes = std::to_array<ProgramCode>({
    {not_knitout, Severity::error, "the first line of a knitout file is not `;!knitout-` and a version", ";!knitout-2"},
    {newer_version, Severity::warning, "the file is of a newer version of the format than 2, and is read as version 2",
     ";!knitout-2"},
    {no_carriers_header, Severity::warning, "no header names the carriers, so that a slip of the pen is a new carrier",
     ";!knitout-2\n;;Carriers: 1 2 3 4 5 6"},
    {no_header, Severity::warning, "a line among the headers is none: name, colon, space, value are wanted",
     ";;Machine: SWGN2"},
    {unknown_header, Severity::warning, "a header that nobody knows; it is kept, and means nothing here",
     ";;Machine: SWGN2\n;;X-Maker: any name that begins with X-"},
    {header_twice, Severity::warning, "a header is given twice; the last one counts", "remove one of the two"},
    {header_value, Severity::warning, "a header's value is none that it can have", ";;Gauge: 15\n;;Position: Center"},
    {not_plain_text, Severity::warning,
     "the lines do not end with a line feed alone, or the file begins with a byte order mark",
     "save as UTF-8 without a byte order mark, with line ends as on Unix"},
    {nul_byte, Severity::error, "the file holds a NUL byte, so it is no text", "save as UTF-8"},
    {not_a_needle, Severity::error, "a needle was wanted: a bed (f, b, or the sliders fs, bs) and a number",
     "knit + f12 1"},
    {unknown_operation, Severity::error, "an operation that knitout does not have", "knit + f0 1"},
    {operand_missing, Severity::error, "an operation lacks an operand", "xfer f0 b0"},
    {operand_extra, Severity::error, "an operation has more operands than it can use",
     "knit + f0 1 ; a comment follows a semicolon"},
    {not_a_direction, Severity::error, "a direction was wanted: + towards greater needle numbers, or -", "knit - f0 1"},
    {not_a_number, Severity::error, "a number was wanted", "rack 0.25"},
    {carrier_undeclared, Severity::error, "a carrier that the header `Carriers` does not name", ";;Carriers: 1 2 3"},
    {carriers_header, Severity::error, "a carrier is declared twice, or there are more carriers than any machine has",
     ";;Carriers: 1 2 3 4 5 6"},
    {program_too_long, Severity::error, "the program is longer than two million instructions",
     "cut the file into several"},
    {extension_passed_over, Severity::note, "an extension operation that changes no loop is passed over",
     "x-stitch-number 5 ; the one that is used"},
});

}  // namespace wale::codes
