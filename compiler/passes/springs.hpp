/// Numbers held together by springs: least squares on differences.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace wale {

/// minimises Σ weight (x_b - x_a - difference)² + Σ weight (x_a - value)².
class Springs {
 public:
  explicit Springs(std::size_t unknowns) : load_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns))) {}
  void between(int a, int b, double difference, double weight);
  void towards(int a, double value, double weight);
  /// Every unknown must be tied to a value, directly or through others.
  Eigen::VectorXd rest() const;

 private:
  std::vector<Eigen::Triplet<double>> stiffness_;
  Eigen::VectorXd load_;
};

}  // namespace wale
