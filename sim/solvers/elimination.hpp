/// In which order points are eliminated from a sparse system, and which dense fronts that makes (Liu 1992).
#pragma once

#include <utility>
#include <vector>

#include "sim/stiffness.hpp"

namespace wale {

/// Where a block of a Stiffness goes in a front.
struct FrontEntry {
  int slot = 0;
  int row = 0, column = 0;  ///< in the front, counted in points
  bool transposed = false;
};

/// So many adjacent rows of a front's update, and where they lie in the parent; counted in points.
struct Run {
  int from = 0, to = 0, length = 0;
};

/// Points that are eliminated together, as one dense matrix.
struct Front {
  std::vector<int> rows;  ///< places in Elimination::order, ascending; the first `own` are eliminated here
  int own = 0;
  int parent = -1;            ///< -1: none
  std::vector<int> children;  ///< ascending
  std::vector<FrontEntry> entries;
  std::vector<Run> into_parent;  ///< of the rows that are not its own, in order
  int size() const { return static_cast<int>(rows.size()); }
};

/// A tree of fronts, children before parents.
struct Elimination {
  std::vector<int> order;  ///< the points, first to last
  std::vector<Front> fronts;
  /// Subtrees [first, last] that have nothing to do with each other, the most work first: for threads.
  std::vector<std::pair<int, int>> branches;
  std::vector<int> trunk;  ///< the fronts that are in no branch, ascending
};

/// By minimum degree on the graph of points (CHOLMOD). `used` says of each slot whether its block may be other than
/// zero; blocks that are not used are left out.
Elimination eliminate(const Stiffness&, const std::vector<char>& used);

}  // namespace wale
