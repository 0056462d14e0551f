/// Half of a symmetric matrix.
#pragma once

#include "sim/fabric.hpp"
#include "sim/large_pages.hpp"

namespace wale {

/// Of a symmetric matrix the lower triangle, column by column.
class LowerTriangle {
 public:
  /// How many it has.
  static Eigen::Index values(Eigen::Index size) { return size * (size + 1) / 2; }

  /// Zero.
  explicit LowerTriangle(Eigen::Index size) : size_(size), values_(static_cast<std::size_t>(values(size)), 0.0) {}

  /// From the diagonal down.
  double* column(Eigen::Index j) { return values_.data() + values(size_) - values(size_ - j); }
  /// Adds it to that of a dense matrix.
  void add_to(Eigen::MatrixXd& matrix) const {
    const double* from = values_.data();
    for (Eigen::Index j = 0; j < size_; from += size_ - j, ++j)
      matrix.col(j).tail(size_ - j) += Eigen::Map<const Eigen::VectorXd>(from, size_ - j);
  }

 private:
  Eigen::Index size_;
  LargeArray<double> values_;
};

}  // namespace wale
