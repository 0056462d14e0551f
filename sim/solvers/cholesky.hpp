/// Sparse Cholesky factors of a Stiffness plus a multiple of the identity: multifrontal, on the threads there are.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/solvers/elimination.hpp"
#include "sim/stiffness.hpp"

namespace wale {

/// Keeps the order of elimination as long as no block is other than zero that was zero: most listed pairs of yarn do
/// not touch, and to leave them out halves the work. One matrix an object. The same bits for any number of threads.
class Cholesky {
 public:
  Cholesky();

  /// Factors K + shift I. False if that is not positive definite.
  [[nodiscard]] bool factor(const Stiffness& K, double shift);
  /// x := (K + shift I)⁻¹ x, after factor() answered true.
  void solve(Eigen::VectorXd& x) const;

 private:
  void analyse(const Stiffness& K);
  bool factor_front(const Stiffness& K, double shift, int front);
  void add_entries(const Stiffness& K, double shift, int front);
  void add_child(int child, int front);
  bool eliminate_own(int front);
  void solve_forward(int front, Eigen::VectorXd& x, std::vector<Eigen::VectorXd>& carried) const;
  void solve_backward(int front, Eigen::VectorXd& x) const;
  Eigen::Map<Eigen::MatrixXd> panel(int front);
  Eigen::Map<const Eigen::MatrixXd> panel(int front) const;

  template <class Visit>
  void upwards(const Visit& visit) const;

  Elimination elimination_;
  std::vector<char> used_;                // by slot: whether the order allows for a block there
  std::vector<std::size_t> panel_at_;     // by front, in panels_
  Eigen::VectorXd panels_;                // the columns of the factor, front by front
  std::vector<Eigen::MatrixXd> updates_;  // by front: what its elimination takes from the rows that are not its own
};

}  // namespace wale
