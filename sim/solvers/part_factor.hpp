/// The Cholesky factor of one part of a matrix and of the border that it shares with others.
#pragma once

#include "sim/solvers/cholmod.hpp"
#include "sim/solvers/ordered_matrix.hpp"

namespace wale {

/// Of a part A and its border B in the whole matrix (A Cᵀ; C B), by CHOLMOD: (L 0; M N) with N Nᵀ = B - C A⁻¹ Cᵀ, which
/// is what the part leaves of the border. Works on the calling thread alone. Not copyable; not for concurrent use.
class PartFactor {
 public:
  /// Symbolic. Throws std::bad_alloc.
  PartFactor(const Stiffness& K, const UsedBlocks& used, const std::vector<int>& part, const std::vector<int>& border);
  ~PartFactor();
  PartFactor(const PartFactor&) = delete;
  PartFactor& operator=(const PartFactor&) = delete;

  /// How many values the factor has.
  std::size_t values() const { return factor_->xsize; }
  /// How many products and sums it takes.
  double factor_work() const { return work_; }

  enum class Status { good, indefinite, no_memory };
  /// Of K + shift I.
  Status factor(const Stiffness& K, double shift);
  /// N Nᵀ, in the upper triangle of a matrix whose rows and columns are the coordinates of the border, last first.
  Eigen::MatrixXd left_of_border() const;

  /// Takes x, by coordinates of the whole, at its own points; keeps y = L⁻¹ x, and adds -M y to `border`.
  Status forward(const Eigen::VectorXd& x, Eigen::VectorXd& border);
  /// x := L⁻ᵀ (y - Mᵀ border) at its own points.
  Status backward(const Eigen::VectorXd& border, Eigen::VectorXd& x);

 private:
  Status solve(int system);
  template <class Do>
  void each_of_border(const Do& act) const;

  cholmod::Common common_;
  OrderedMatrix matrix_;
  int own_ = 0;      // coordinates before the border
  double work_ = 0;  // see factor_work()
  cholmod::Factor factor_{nullptr, {common_.get()}};
  Eigen::VectorXd x_;                                                // in the order of elimination
  cholmod_dense *solution_ = nullptr, *y_ = nullptr, *e_ = nullptr;  // made by cholmod_solve2, and used again
};

}  // namespace wale
