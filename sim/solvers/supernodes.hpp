/// In which steps a part of a matrix is eliminated, and which rows that fills.
#pragma once

#include <vector>

#include "sim/solvers/used_blocks.hpp"

namespace wale {

/// Of a part and its border. A supernode is a run of the part's points whose columns of the Cholesky factor have the
/// same rows; they are eliminated at once. Points are known by their places in the order of elimination.
class Supernodes {
 public:
  /// `part`: first eliminated first, but for what branches that do not meet have among each other. Throws
  /// std::bad_alloc.
  Supernodes(const Stiffness& K, const UsedBlocks& used, const std::vector<int>& part, const std::vector<int>& border);

  int count() const { return static_cast<int>(parent_.size()); }
  /// Place of its first column; `supernode` may be one behind the last.
  int first(int supernode) const { return first_[static_cast<std::size_t>(supernode)]; }
  int width(int supernode) const { return first(supernode + 1) - first(supernode); }
  int height(int supernode) const { return static_cast<int>(end_of_rows(supernode) - rows(supernode)); }
  /// Its height() rows are places, ascending; first its own columns.
  const int* rows(int supernode) const { return rows_.data() + row_starts_[static_cast<std::size_t>(supernode)]; }
  /// Which takes what it leaves; -1: the border does.
  int parent(int supernode) const { return parent_[static_cast<std::size_t>(supernode)]; }

  /// The point at each place: those of the part, then those of the border as they were given.
  const std::vector<int>& order() const { return order_; }
  /// How many places are the part's.
  int own() const { return first_.back(); }

 private:
  const int* end_of_rows(int supernode) const { return rows(supernode + 1); }
  void find_parents();

  std::vector<int> order_;
  std::vector<int> first_;
  std::vector<std::size_t> row_starts_;
  std::vector<int> rows_;
  std::vector<int> parent_;
};

}  // namespace wale
