/// The control points of a periodic fabric that follow others.
#pragma once

#include <array>
#include <vector>

#include "sim/fabric.hpp"
#include "sim/stiffness.hpp"

namespace wale {

/// Of the columns of State::q, those that move by themselves, and how the others follow: the last three control points
/// of a periodic yarn are its first three, one course period on. The two periods are the last two columns. A fabric
/// that is not periodic has nothing tied: then every column is free.
class Ties {
 public:
  explicit Ties(const Fabric&);

  bool empty() const { return first_.empty(); }
  /// Columns of State::q.
  int columns() const { return columns_; }
  /// Those that move by themselves.
  int free_columns() const { return free_; }

  /// Of the motion of all columns, that of the free ones.
  Points pick(const Points& all) const;
  /// Motion of all columns from that of the free ones.
  Points spread(const Points& free) const;
  /// Force on the free columns from that on all: the transpose of spread().
  Points gather(const Points& all) const;
  /// Second derivative by the free columns from that by all. `by_free` has free_columns() points, and is cleared.
  void gather(const Stiffness& by_all, Stiffness& by_free) const;
  /// The free column that is a column, or that it follows.
  int free_column(int column) const { return empty() ? column : first_[static_cast<std::size_t>(column)]; }

 private:
  /// What a column is the sum of: one free column, or two.
  std::array<int, 2> parts(int column) const;
  bool follows(int column) const { return follows_[static_cast<std::size_t>(column)]; }

  int columns_ = 0, free_ = 0;
  std::vector<int> first_;     // by column
  std::vector<char> follows_;  // by column: a course period on from first_
};

}  // namespace wale
