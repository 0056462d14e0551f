/// In which order the points of a Stiffness are eliminated, and which of them can be at the same time.
#pragma once

#include <vector>

#include "sim/solvers/used_blocks.hpp"

namespace wale {

/// From so many points on a matrix is large: a border costs less than a second thread saves, and memory is short.
inline constexpr int many_points = 4000;

/// Points in parts between which there is no block, and a border that has blocks with all of them.
struct Dissection {
  std::vector<std::vector<int>> parts;  ///< first eliminated first
  std::vector<int> border;              ///< eliminated after all parts
};

/// Two parts of a large matrix, by nested dissection (METIS, through CHOLMOD); one without a border of a small one, by
/// minimum degree (AMD). Both on the graph of points, which has nine times fewer entries than that of coordinates.
Dissection dissect(const Stiffness& K, const UsedBlocks& used);

/// Whether there is still no block between any two parts.
bool separates(const Dissection&, const Stiffness& K, const UsedBlocks& used);

}  // namespace wale
