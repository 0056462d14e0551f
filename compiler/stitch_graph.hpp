/// Which loop of which yarn is pulled through which others.
#pragma once

#include <string>
#include <vector>

#include "compiler/program.hpp"

namespace wale {

enum class LoopKind : std::uint8_t { knit, tuck };

struct Loop {
  LoopKind kind = LoopKind::knit;
  Needle needle;             ///< where it was made: front shows a knit, back a purl
  Direction direction = Direction::none;
  int carrier = 0;           ///< index into StitchGraph::carriers
  int course = 0;            ///< passes of its yarn before it
  std::vector<int> through;  ///< loops it was pulled through, front to back
  bool held = false;         ///< still on a needle at the end
  ChartCell cell;
  double stitch_length = 0;  ///< m; 0 if not said
  Span span;                 ///< the instruction that made it
};

struct YarnPath {
  int carrier = 0;
  std::vector<int> loops;    ///< in the order they were made
};

struct StitchGraph {
  std::vector<std::string> carriers;
  std::vector<Loop> loops;   ///< in the order they were made, all yarns
  std::vector<YarnPath> yarns;
};

/// One loop a line; what `--show graph` prints.
std::string print(const StitchGraph&);

}  // namespace wale
