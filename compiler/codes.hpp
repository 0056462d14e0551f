/// Every diagnostic code of the compiler: what it means and what to write instead; `wale explain` reads it.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "compiler/diagnostic.hpp"
#include "compiler/front/knitout_codes.hpp"
#include "compiler/passes/program_codes.hpp"

namespace wale {

using CodeInfo = codes::ProgramCode;

/// Codes of the text front: F files, Y YAML, U units, C charts, M materials, S scenes.
inline constexpr auto front_codes = std::to_array<CodeInfo>({
    {"F001", Severity::error, "a file that the scene names cannot be read",
     "fabric: {pattern: ../patterns/jersey.yaml}   # relative to the folder of the scene"},

    {"Y001", Severity::error, "the text is not YAML, is empty, or holds several documents",
     "check indentation, colons, brackets and quotes; put colours in quotes, as # begins a comment"},
    {"Y002", Severity::error, "a tab indents a line, which YAML does not allow", "indent with spaces"},
    {"Y003", Severity::error, "a key that nobody knows", "correct the spelling: `wales: 12`, not `walse: 12`"},
    {"Y004", Severity::error, "a value of the wrong shape: a list, a map or a single value was wanted",
     "bands:\n  - {stitch: jersey, courses: 12}"},
    {"Y005", Severity::error, "something that is needed is missing", "- {stitch: jersey, courses: 12}"},
    {"Y006", Severity::error, "a key is given twice in one map", "remove one of the two"},
    {"Y007", Severity::error, "a count is no whole number, or is zero, negative or absurd", "wales: 12"},
    {"Y008", Severity::error, "a word that is not one of those allowed here", "form: tube"},

    {"U001", Severity::error, "a quantity has no unit", "stitch_length: 7.23 mm"},
    {"U002", Severity::error, "a quantity has a unit of another dimension", "linear_density: 77 tex   # not 77 N"},
    {"U003", Severity::error, "a quantity does not begin with a number", "duration: 2 s"},
    {"U004", Severity::error, "a unit that nobody knows", "stretch_modulus: 79 MPa"},
    {"U005", Severity::error, "a quantity is zero, negative or absurd", "contact_diameter: 0.524 mm"},

    {"C001", Severity::error, "a chart was wanted, and this is none, or one of an unknown version", "knit: 1"},
    {"C002", Severity::error, "a stitch that is neither built in nor one of the chart's patterns",
     "stitch: rib 2x2   # `wale patterns` lists what there is"},
    {"C003", Severity::error, "a symbol in a picture that is not in the legend", "symbols: {\"-\": purl}"},
    {"C004", Severity::error, "the rows of a picture are not equally wide", "stitch: |\n  kkpp\n  ppkk"},
    {"C005", Severity::error, "a stitch that charts cannot hold yet: a crossing, a tuck, a miss",
     "draw the cell with k or p"},
    {"C006", Severity::error, "the panels of a band do not add up to the width of the chart",
     "wales: 12\nbands:\n  - courses: 6\n    panels:\n      - {stitch: jersey, wales: 4}\n      - {stitch: purl, "
     "wales: 8}"},
    {"C007", Severity::error, "a picture is wider or higher than the place where it is drawn",
     "draw it smaller, or give the band more courses or wales"},
    {"C008", Severity::error, "a yarn that is not among the chart's yarns", "yarns: {main: {material: acrylic_16_2}}"},
    {"C009", Severity::error, "a picture is empty, or not a block of text", "stitch: |\n  kkpp\n  ppkk"},
    {"C010", Severity::error, "a symbol or a pattern's name that cannot be used, or is taken",
     "symbols: {\".\": knit}"},
    {"C011", Severity::error, "a thing is said twice, in two ways", "keep one of the two"},
    {"C012", Severity::error, "a chart, or a picture in it, is bigger than any fabric to be simulated", "courses: 40"},
    {"C013", Severity::error, "the wales or courses that a scene asks for do not suit the chart",
     "leave `courses:` out of the scene if the chart has several bands"},
    {"C014", Severity::error,
     "a chart that cannot be one repeat of a periodic fabric: a tube, a course of several yarns",
     "bands:\n  - {stitch: rib 1x1, courses: 2, yarn: [a, b]}   # a yarn goes right across"},
    {"C020", Severity::warning,
     "the yarn is thicker than its stitches have room for: a jersey of hard tubes jams at stitch length / diameter = "
     "13.27",
     "stitch_length: 7.23 mm   # with a yarn of 0.524 mm"},
    {"C021", Severity::warning, "colourwork other than intarsia is knitted as intarsia", "colorwork: intarsia"},
    {"C022", Severity::warning, "a stitch length of the chart is replaced by the scene's",
     "leave `stitch_length:` out of the scene"},
    {"C023", Severity::warning, "a structure is cut off where a periodic fabric repeats it",
     "fabric: {pattern: rib_2x2.yaml, wales: 4, courses: 2, periodic: true}"},

    {"M001", Severity::error, "a material that nobody has defined", "material: acrylic_16_2"},
    {"M002", Severity::error, "the quantities of a material are incomplete, or contradict each other",
     "material: {stretch_modulus: 79 MPa, bend_modulus: 0.249 MPa, radius: 0.524 mm}"},

    {"S001", Severity::error, "a scene was wanted, and this is none, or one of an unknown version", "scene: 1"},
    {"S002", Severity::error, "a scene has no stages, so nothing would happen",
     "stages:\n  - {name: tighten, duration: 1 s, tighten: 100 %, hold: ends}\n  - {name: relax, duration: 1 s}\n"
     "  - {name: pull, duration: 8 s, pull: {along: wale, to: 60 %}}"},
    {"S003", Severity::error, "a strain without a direction", "pull: {along: wale, to: 60 %}"},
    {"S004", Severity::error, "a stage is told two things that exclude each other",
     "- {name: tighten, duration: 1 s, tighten: 100 %, hold: ends}\n"
     "- {name: pull, duration: 8 s, pull: {along: course, to: 60 %}}"},
    {"S005", Severity::error, "nothing acts on the yarns in a stage", "effects: {stretch: , bend: , contact: }"},
    {"S006", Severity::warning, "so few segments a stitch that the spline cuts corners", "segments_per_stitch: 12"},
    {"S007", Severity::error, "a scene asks a chart for what only a knitout file has, or the other way about",
     "fabric: {pattern: cable.k, crop: {courses: 1-20}}   # of a chart: wales: 12, courses: 20"},
    {"S008", Severity::error, "a stitch setting that no program has, in a table of stitch lengths",
     "stitch_length: {otherwise: 9 mm, 6: 9.5 mm, 25/40: 8 mm}"},
    {"S009", Severity::error, "a scene names a yarn or a carrier that its pattern does not have",
     "fabric: {pattern: plating.k, yarn: acrylic_16_2, yarns: {2: paper-as-printed}}"},
    {"S010", Severity::error, "a scene asks a periodic fabric for what only a swatch has, or the other way about",
     "- {name: tighten, duration: 1 s, tighten: 100 %}\n"
     "- {name: stretch, duration: 8 s, deform: {wale: 100 %, course: free, shear: held}}"},
    {"S011", Severity::error, "a list of strains stands still somewhere, or is not as long as the one beside it",
     "pull: {along: wale, to: [60 %, 0 %, 60 %, 0 %]}"},
    {"S012", Severity::error, "pressure in a fabric that is no tube, so that it encloses nothing",
     "form: tube   # in the chart; then in the scene `effects: {pressure: {to: 2 kPa}}`"},
    {"S013", Severity::error, "an effect on a region in which there is no stitch, or of a fabric that repeats",
     "gravity: {on: {courses: 5-8, wales: 1-4}}   # both from 1, as the chart is numbered"},
});

/// All codes, the front's first.
inline constexpr auto code_table = [] {
  std::array<CodeInfo, front_codes.size() + codes::knitout_codes.size() + codes::program_codes.size()> all{};
  auto end = std::copy(front_codes.begin(), front_codes.end(), all.begin());
  end = std::copy(codes::knitout_codes.begin(), codes::knitout_codes.end(), end);
  std::copy(codes::program_codes.begin(), codes::program_codes.end(), end);
  return all;
}();

/// Null if there is no such code.
constexpr const CodeInfo* find_code(std::string_view code) {
  for (const CodeInfo& info : code_table) {
    if (info.code == code) return &info;
  }
  return nullptr;
}

}  // namespace wale
