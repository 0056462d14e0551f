/// The sparse symmetric matrix of second derivatives, in 3 x 3 blocks on a pattern that is kept between uses.
#pragma once

#include <omp.h>

#include <map>
#include <memory>
#include <vector>

#include "sim/fabric.hpp"
#include "sim/large_pages.hpp"

namespace wale {

/// 3M x 3M, symmetric; blocks (i, j) with i <= j are stored. Blocks that were never touched are zero. A block keeps its
/// slot, so a caller that adds to the same blocks again and again need look for them once only: see places(). Copies
/// share the pattern: a slot that one of them makes is one of all, and each has values of its own.
class Stiffness {
 public:
  explicit Stiffness(int points);

  /// Sets every value to zero and keeps the pattern.
  void clear();
  /// Gives a value, zero, to slots that a copy has made.
  void fit();
  /// Adds to block (i, j), i <= j; block (j, i) follows by symmetry. A diagonal block must be symmetric.
  void add(int i, int j, const Mat3& block) { add_at(slot(i, j), block); }
  /// Where block (i, j), i <= j, lies; made if it is new.
  int slot(int i, int j);
  /// Appends the slots of blocks (i, j) ... (i, j + count - 1).
  void slots(int i, int j, int count, std::vector<int>& out);
  /// Writes the slots of blocks (i, j) ... (i, j + count - 1) to `out` if there are all of them, and answers that.
  bool find_slots(int i, int j, int count, int* out) const;
  /// Writes them in any case.
  void make_slots(int i, int j, int count, int* out);
  void add_at(int slot, const Mat3& block) { values_[static_cast<std::size_t>(slot)] += block; }
  const Mat3& at(int slot) const { return values_[static_cast<std::size_t>(slot)]; }

  /// The slots of all blocks that `owner` adds to. `list(slots)` is called to fill them when `owner` comes with a
  /// `version` (of its own list of blocks) for the first time. The reference is good until the next call.
  template <class List>
  const std::vector<int>& places(const void* owner, long version, const List& list) {
    auto [known, is_new] = pattern_->places.try_emplace(owner);
    Places& of = known->second;
    if (is_new || of.version != version) {
      of.slots.clear();
      list(of.slots);
      of.version = version;
    }
    fit();
    return of.slots;
  }

  /// Multiplies every value.
  void scale(double factor);
  /// Adds `factor` times another matrix of as many points.
  void add(const Stiffness& other, double factor);
  /// Adds what another matrix has between some of its points, ascending, which are all of these.
  void add_part(const Stiffness& of, const std::vector<int>& points);
  /// Takes coordinate `axis` of a point out: no force on it, and none by it, but `diagonal` times its own motion.
  void hold(int point, int axis, double diagonal);
  /// How many blocks there are.
  std::size_t slots() const { return pattern_->slots; }
  int points() const { return static_cast<int>(pattern_->rows.size()); }

  /// Block (row, column) of the full matrix: the one in `slot`, or its transpose if column < row.
  struct Entry {
    int column = 0, slot = 0;
  };
  /// A block row of the full matrix, columns ascending.
  const std::vector<Entry>& row(int point) const { return pattern_->rows[static_cast<std::size_t>(point)]; }
  /// y = K x on vectors of length 3M.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;

 private:
  struct Places {
    long version = 0;
    std::vector<int> slots;
  };
  struct Pattern {
    std::vector<std::vector<Entry>> rows;
    std::map<const void*, Places> places;
    std::size_t slots = 0;
    void enter(int row, int column, int slot);
  };

  std::shared_ptr<Pattern> pattern_;
  LargeArray<Mat3> values_;  // by slot
};

/// Calls `add(first, last)` on each thread, or on one if the work is `little`, with a range of points; together they
/// are all. A thread that adds only to columns and blocks (i, j) with first <= i < last, in an order that does not
/// depend on the range, gives every sum the same bits for any number of threads.
template <class Add>
void share_points(int points, bool little, const Add& add) {
#pragma omp parallel if (!little)
  {
    const long threads = omp_get_num_threads(), mine = omp_get_thread_num();
    add(static_cast<int>(points * mine / threads), static_cast<int>(points * (mine + 1) / threads));
  }
}

}  // namespace wale
