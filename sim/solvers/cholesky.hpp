/// Sparse Cholesky factors of a Stiffness plus a multiple of the identity: multifrontal, on the threads there are.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/solvers/elimination.hpp"
#include "sim/stiffness.hpp"

namespace wale {

/// Keeps the order of elimination as long as the pattern stays. The same bits for any number of threads.
class Cholesky {
 public:
  Cholesky();

  /// Factors K + shift I. False if that is not positive definite.
  [[nodiscard]] bool factor(const Stiffness& K, double shift);
  /// x := (K + shift I)⁻¹ x, after factor() answered true.
  void solve(Eigen::VectorXd& x) const;

 private:
  using Real = double;
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using Panel = Eigen::Map<Matrix>;

  void analyse(const Stiffness& K);
  bool factor_front(const Stiffness& K, double shift, int front);
  void add_entries(const Stiffness& K, double shift, int front);
  void add_child(int child, int front);
  bool eliminate_own(int front);
  void solve_forward(int front, Vector& x, std::vector<Vector>& carried) const;
  void solve_backward(int front, Vector& x) const;
  Panel panel(int front) const;

  template <class Visit>
  void upwards(const Visit& visit) const;

  Elimination elimination_;
  const Stiffness* analysed_ = nullptr;
  long version_ = -1;
  std::vector<std::size_t> panel_at_;  // by front, in panels_
  mutable Vector panels_;              // the columns of the factor, front by front
  std::vector<Matrix> updates_;        // by front: what its elimination takes from the rows that are not its own
};

}  // namespace wale
