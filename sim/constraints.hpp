/// Linear constraints on what may move: yarn ends held in place or in direction, and what else is held.
#pragma once

#include <functional>
#include <vector>

#include "sim/effect.hpp"
#include "sim/scene.hpp"

namespace wale {

/// C x = constant, with few rows; x is the 3M-vector of all control-point coordinates (column-major Points).
class Constraints {
 public:
  /// Holds every clamp where `q` has it.
  Constraints(const Fabric&, const std::vector<Clamp>&, const Points& q);
  /// Holds Σ `row`_k · x_k, in place of all that was held; `row` has the columns of what may move.
  void hold_only(const Points& row) { rows_ = row.reshaped().transpose(); }
  bool empty() const { return rows_.rows() == 0; }
  /// rows x 3M, dense: there are at most five rows a held end.
  const Eigen::MatrixXd& rows() const { return rows_; }
  /// Changes x = A⁻¹ b into the solution of A x + Cᵀ λ = b, C x = 0; `solve` applies A⁻¹ in place to 3M-vectors.
  void project(Eigen::VectorXd& x, const std::function<void(Eigen::VectorXd&)>& solve) const;

 private:
  Eigen::MatrixXd rows_;
};

}  // namespace wale
