/// Linear constraints on control points: yarn ends held in place or in direction.
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
  bool empty() const { return rows_.rows() == 0; }
  /// rows x 3M, dense: there are at most five rows a held end.
  const Eigen::MatrixXd& rows() const { return rows_; }
  /// Changes x = A⁻¹ b into the solution of A x + Cᵀ λ = b, C x = 0; `solve` applies A⁻¹ in place to 3M-vectors.
  void project(Eigen::VectorXd& x, const std::function<void(Eigen::VectorXd&)>& solve) const;

 private:
  Eigen::MatrixXd rows_;
};

}  // namespace wale
