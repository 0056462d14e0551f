/// Which loop of which yarn is pulled through which others.
#pragma once

#include <string>
#include <vector>

#include "compiler/program.hpp"

namespace wale {

enum class LoopKind : std::uint8_t { knit, tuck };

/// Where a carrier waits: beside a needle, and goes with it when its loops are transferred.
struct Stop {
  Needle needle;
  Direction side = Direction::none;  ///< increasing: to the right of the needle; none if it has not been anywhere yet
};

/// A loop goes to another needle.
struct Move {
  Needle to;
  double racking = 0;
  int instruction = -1;  ///< index into Program::code; the order of all that happens
};

struct Loop {
  LoopKind kind = LoopKind::knit;
  Needle needle;  ///< where it was made: front shows a knit, back a purl
  Direction direction = Direction::none;
  int carrier = 0;           ///< index into StitchGraph::carriers
  int course = 0;            ///< passes of its yarn before it
  std::vector<int> through;  ///< loops it was pulled through, front to back
  bool held = false;         ///< still on a needle at the end
  ChartCell cell;
  double stitch_length = 0;  ///< m; 0 if not said
  Span span;                 ///< the instruction that made it

  int instruction = -1;     ///< index into Program::code
  double racking = 0;       ///< when it was made; position(needle, racking) is where it stood
  Stop from;                ///< where its carrier came from
  std::vector<Move> moves;  ///< transfers that it underwent, in order; of two that pass each other, the one on the
                            ///< front bed passes in front
  Needle last_needle;       ///< the last to hold it
  double last_racking = 0;  ///< when it left that needle, or at the end
  int released = -1;        ///< the instruction by which it left its last needle; -1 if held
  bool dropped = false;     ///< let go while nothing was pulled through it, so that it runs
};

/// A yarn passes a needle without a stitch.
struct Miss {
  int loops_before = 0;  ///< how many loops of the yarn were made before
  Needle needle;
  Direction direction = Direction::none;
  double racking = 0;
  int instruction = -1;
};

/// One piece of yarn: a carrier that goes out and comes in again brings another.
struct YarnPath {
  int carrier = 0;
  std::vector<int> loops;           ///< in the order they were made
  std::vector<Miss> misses;         ///< in the order they were made
  int came_in = -1, went_out = -1;  ///< instructions; -1 if there is none
  Stop end;                         ///< where its carrier stood when it went out, or at the end
};

/// What one needle holds at the end.
struct HeldLoops {
  Needle needle;
  std::vector<int> loops;  ///< front to back
};

struct StitchGraph {
  std::vector<std::string> carriers;
  std::vector<Loop> loops;  ///< in the order they were made, all yarns; those that knit as one front to back
  std::vector<YarnPath> yarns;
  std::vector<HeldLoops> on_needles;  ///< by bed, then from left to right
  int widest = 0;                     ///< needles that held loops at the same time, at most
};

/// The loop before each on its yarn; -1 for a yarn's first.
std::vector<int> loops_before(const StitchGraph&);

/// On which needle a loop is before an instruction.
Needle needle_before(const Loop&, int instruction);

/// The course of each loop, from 0: one above the highest loop that it is pulled through; a loop through nothing lies
/// beside the one before it on its yarn.
std::vector<int> courses_of(const StitchGraph&);

/// The longest `Loop::stitch_length`, m; 0 if none is said.
double longest_stitch(const StitchGraph&);

/// One loop a line; what `--show graph` prints.
std::string print(const StitchGraph&);

}  // namespace wale
