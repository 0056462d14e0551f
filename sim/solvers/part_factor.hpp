/// The Cholesky factor of one part of a matrix that shares a border with others.
#pragma once

#include "sim/solvers/front_sequence.hpp"
#include "sim/solvers/lower_triangle.hpp"
#include "sim/solvers/panels.hpp"

namespace wale {

/// Of a part A and its border B in the whole matrix (A Cᵀ; C B): the columns (L; M) of its factor. Works on the calling
/// thread alone. Not copyable; not for concurrent use.
class PartFactor {
 public:
  /// Symbolic. Throws std::bad_alloc.
  PartFactor(const Stiffness& K, const UsedBlocks& used, const std::vector<int>& part, const std::vector<int>& border,
             Precision precision);
  PartFactor(const PartFactor&) = delete;
  PartFactor& operator=(const PartFactor&) = delete;

  /// How many values the factor has.
  std::size_t values() const { return panels_.values(); }
  /// How many products and sums it takes.
  double factor_work() const;

  /// Factors K + shift I, and adds what the border loses, C A⁻¹ Cᵀ with a minus. False if A is not positive definite.
  /// Throws std::bad_alloc.
  [[nodiscard]] bool factor(const Stiffness& K, double shift, const UsedBlocks& used, LowerTriangle& border);

  /// Takes x, by coordinates of the whole, at its own points; keeps y = L⁻¹ x, and adds -M y to `border`.
  void forward(const Eigen::VectorXd& x, Eigen::VectorXd& border);
  /// x := L⁻ᵀ (y - Mᵀ border) at its own points.
  void backward(const Eigen::VectorXd& border, Eigen::VectorXd& x);

 private:
  Supernodes supernodes_;
  FrontSequence sequence_;
  Panels panels_;
  Eigen::VectorXd y_;  // by places
};

}  // namespace wale
