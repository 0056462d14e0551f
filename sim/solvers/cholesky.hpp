/// Sparse Cholesky factors of a Stiffness plus a multiple of the identity.
#pragma once

#include <memory>

#include "sim/stiffness.hpp"

namespace wale {

/// A large matrix is factored in two parts at the same time and then along the border between them. Keeps the order of
/// elimination and the symbolic factor as long as the pattern stays. Leaves OpenMP's settings as they are: the same
/// bits for any number of threads. Not copyable; not for concurrent use.
class Cholesky {
 public:
  Cholesky();
  ~Cholesky();
  Cholesky(const Cholesky&) = delete;
  Cholesky& operator=(const Cholesky&) = delete;

  /// Factors K + shift I. False if that is not positive definite. Throws std::bad_alloc.
  [[nodiscard]] bool factor(const Stiffness& K, double shift);
  /// How many solves take about as long as another factor; -1 without one.
  int solves_a_factor() const;
  /// Drops the symbolic factor: what comes next depends on nothing that came before.
  void forget();
  /// x := (K + shift I)⁻¹ x, after factor() answered true. Throws std::bad_alloc.
  void solve(Eigen::VectorXd& x) const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace wale
