/// The control points of a periodic fabric that follow others.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/image.hpp"
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

  /// Of a fabric that curls about its wales, around which its yarns go on: brings what follows to where it follows.
  void follow(Points& q) const;
  /// From now on motions and forces are those near `q`; matters to such a fabric only.
  void look_at(const Points& q);
  /// Whether that makes a difference.
  bool turn() const { return cell_.has_value(); }

  /// Of the motion of all columns, that of the free ones.
  Points pick(const Points& all) const;
  /// Motion of all columns from that of the free ones.
  Points spread(const Points& free) const;
  /// Force on the free columns from that on all: the transpose of spread().
  Points gather(const Points& all) const;
  /// Second derivative by the free columns from that by all. `by_free` has free_columns() points, and is cleared.
  void gather(const Stiffness& by_all, Stiffness& by_free) const;
  /// What is added to that as the columns that follow turn with the periods; `force` is that on all columns.
  void add_turning(const Points& force, Stiffness& by_free) const;
  /// The free column that is a column, or that it follows.
  int free_column(int column) const { return empty() ? column : first_[static_cast<std::size_t>(column)]; }
  /// The column that a column goes along with; itself if that is free.
  int leader(int column) const { return leader_.empty() ? column : leader_[static_cast<std::size_t>(column)]; }

 private:
  /// A free column that a column moves with, and how.
  struct Part {
    int free = -1;
    Mat3 by = Mat3::Identity();
  };
  /// What a column is the sum of: one free column, two, or three.
  std::array<Part, 3> parts(int column) const;
  bool follows(int column) const { return follows_[static_cast<std::size_t>(column)]; }

  int columns_ = 0, free_ = 0;
  std::vector<int> first_;            // by column
  std::vector<char> follows_;         // by column: a course period on from first_
  std::vector<int> leader_;           // by column
  std::optional<PeriodicCell> cell_;  // of a fabric that curls about its wales
  std::optional<Image> on_;           // a course period on there, where it was looked at last
  Points seen_;                       // all columns then
};

}  // namespace wale
