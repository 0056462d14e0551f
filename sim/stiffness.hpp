/// The sparse symmetric matrix of second derivatives, in 3 x 3 blocks on a pattern that is kept between uses.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "sim/fabric.hpp"

namespace wale {

/// 3M x 3M, symmetric; the block upper triangle is stored. Blocks that were never touched are zero.
/// Not for concurrent use: effects compute in parallel and add in order, so that the sum is the same every time.
class Stiffness {
 public:
  explicit Stiffness(int points);

  /// Sets every value to zero and keeps the pattern.
  void clear();
  /// Forgets the pattern too.
  void forget();
  /// Adds to block (i, j), i <= j; block (j, i) follows by symmetry. A diagonal block must be symmetric.
  void add(int i, int j, const Mat3& block) { values_[static_cast<std::size_t>(slot(i, j))] += block; }
  /// Makes room for block (i, j), i <= j, that may be filled later, so that the pattern need not grow then.
  void touch(int i, int j) { slot(i, j); }

  /// True once for each `version` that `owner` comes with: then it should touch() its blocks.
  bool admit(const void* owner, long version) {
    auto [known, is_new] = admitted_.try_emplace(owner, version);
    return is_new || std::exchange(known->second, version) != version;
  }

  int points() const { return static_cast<int>(columns_.size()); }
  /// Grows by one whenever the pattern changes: a symbolic factorisation is good for one version.
  long version() const { return version_; }

  /// The scalar upper triangle by compressed columns, row indices ascending.
  struct Compressed {
    std::vector<int> start, row;
    std::vector<double> value;
  };
  /// Refreshes `out`; its pattern is rebuilt only if `out_version` is not this version.
  void compress(Compressed& out, long& out_version) const;
  /// y = K x on vectors of length 3M.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;

 private:
  struct Entry {
    int row = 0, slot = 0;
  };
  int slot(int i, int j);

  std::vector<std::vector<Entry>> columns_;  // by row, ascending
  std::vector<Mat3> values_;
  std::map<const void*, long> admitted_;
  long version_ = 0;
};

}  // namespace wale
