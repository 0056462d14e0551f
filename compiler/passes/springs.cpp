#include "compiler/passes/springs.hpp"

#include <Eigen/SparseCholesky>

namespace wale {

void Springs::between(int a, int b, double difference, double weight) {
  if (a == b) return;
  stiffness_.emplace_back(a, a, weight);
  stiffness_.emplace_back(b, b, weight);
  stiffness_.emplace_back(a, b, -weight);
  stiffness_.emplace_back(b, a, -weight);
  load_(a) -= weight * difference;
  load_(b) += weight * difference;
}

void Springs::towards(int a, double value, double weight) {
  stiffness_.emplace_back(a, a, weight);
  load_(a) += weight * value;
}

Eigen::VectorXd Springs::rest() const {
  Eigen::SparseMatrix<double> stiffness(load_.size(), load_.size());
  stiffness.setFromTriplets(stiffness_.begin(), stiffness_.end());
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(stiffness).solve(load_);
}

}  // namespace wale
