/// A chart's loops by course and wale, as they were compiled.
#pragma once

#include <vector>

#include "compiler/arrangement.hpp"
#include "compiler/chart.hpp"

namespace wale {

struct GridLoop {
  int loop = -1;  ///< index into StitchGraph::loops
  int course = 0, wale = 0;
  int sign = 1;  ///< +1 knit, -1 purl, seen from the face
  double stitch_length = 0;
};

struct LoopGrid {
  int wales = 0, courses = 0;
  std::vector<std::vector<GridLoop>> rows;  ///< [course][wale]
  std::vector<bool> from_left;              ///< by course: knitted from left to right
};

inline LoopGrid grid_of(const Chart& chart, const StitchGraph& graph, const Arrangement& arrangement) {
  LoopGrid grid{chart.wales(), chart.course_count(), {}, {}};
  grid.rows.assign(static_cast<std::size_t>(grid.courses), std::vector<GridLoop>(static_cast<std::size_t>(grid.wales)));
  for (std::size_t i = 0; i < graph.loops.size(); ++i) {
    const ChartCell cell = graph.loops[i].cell;
    grid.rows[static_cast<std::size_t>(cell.course)][static_cast<std::size_t>(cell.wale)] = {
        static_cast<int>(i), cell.course, cell.wale, arrangement.loops[i].sign, graph.loops[i].stitch_length};
  }
  for (const auto& row : grid.rows)
    grid.from_left.push_back(arrangement.loops[static_cast<std::size_t>(row.front().loop)].heading > 0);
  return grid;
}

}  // namespace wale
