/// What a V-bed machine is told, one needle at a time.
#pragma once

#include <array>
#include <compare>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/source.hpp"

namespace wale {

enum class Bed : std::uint8_t { front, back, front_slider, back_slider };
struct Needle {
  Bed bed = Bed::front;
  int index = 0;
  auto operator<=>(const Needle&) const = default;
};
enum class Op : std::uint8_t {
  in,
  inhook,
  releasehook,
  out,
  outhook,
  knit,
  tuck,
  split,
  miss,
  rack,
  stitch,
  pause,
  extension
};
enum class Direction : std::uint8_t { none, increasing, decreasing };

/// Where the first-named of several carriers lies that knit as one, seen from the face; knitout does not say.
enum class Plating : std::uint8_t { first_in_front, first_behind };
inline constexpr std::array<std::string_view, 2> plating_words{"first_in_front", "first_behind"};  ///< by Plating

/// The cell of a chart for which an instruction stands; -1 in a machine's own program.
struct ChartCell {
  int course = -1, wale = -1;
  auto operator<=>(const ChartCell&) const = default;
};

struct Instruction {  ///< drop, amiss, xfer are knit, tuck, split without carriers, as the knitout specification has it
  Op op = Op::pause;
  Direction direction = Direction::none;
  Needle needle, other;       ///< `other` for split and xfer: where loops go
  std::vector<int> carriers;  ///< indices into Program::carriers; several knit as one (plating)
  double value[2] = {0, 0};   ///< rack R; stitch L T
  int extension = -1;         ///< index into Program::extensions
  ChartCell cell;
  double stitch_length = 0;  ///< yarn length of the loop made, m; 0 if the program does not say
  Span span;
};

/// A line `;;name: value` before the first instruction.
struct Header {
  std::string name, value;
};

struct Program {
  std::vector<std::string> carriers;
  std::vector<Instruction> code;
  int version = 2;                      ///< of the format, as the file has it
  std::string machine;                  ///< "SWGN2", "Kniterate"; empty if the program does not say
  double gauge = 0;                     ///< needles per inch; 0 if not said
  std::string position;                 ///< where on the bed: Left, Center, Right, Keep; empty if not said
  std::string rails;                    ///< the carriers as written, where several share a rail: "L1,L2;R1"
  std::vector<Header> headers;          ///< all others: yarn hints (`Yarn-1`), `Width`, `X-...`
  std::vector<std::string> extensions;  ///< lines of extension operations as written: "x-stitch-number 5"
  Plating plating = Plating::first_in_front;
};

inline bool on_slider(const Needle& at) { return at.bed == Bed::front_slider || at.bed == Bed::back_slider; }
inline bool on_back(const Needle& at) { return at.bed == Bed::back || at.bed == Bed::back_slider; }
/// Where a needle stands along the front bed, in needles, when the back bed is racked to the right by `racking`.
inline double position(const Needle& at, double racking) { return on_back(at) ? at.index + racking : at.index; }

/// `f3`, `b-2`, `fs0`.
std::string print(const Needle&);
/// One instruction in knitout's words, without a line end; carriers by the names of `program`.
std::string print(const Instruction&, const Program& program);
/// A knitout file, one instruction a line; what `--show program` prints, and what `parse_knitout` reads back. Its
/// comments count courses from 1.
std::string print(const Program&);

}  // namespace wale
