/// Which part of a continued chart is the one repeat that becomes a periodic fabric.
#pragma once

#include "compiler/chart.hpp"
#include "compiler/program.hpp"

namespace wale {

/// A repeat of a periodic fabric in the middle of a larger piece, in which it is continued to all sides.
struct Repeat {
  int wales = 0, courses = 0;  ///< of the repeat
  int margin = 0;              ///< stitches of the larger piece beyond it, on every side

  bool holds(const ChartCell& cell) const {
    return cell.wale >= margin && cell.wale < margin + wales && cell.course >= margin && cell.course < margin + courses;
  }
};

}  // namespace wale
