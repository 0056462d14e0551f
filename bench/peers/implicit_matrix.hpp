/// The matrix of an implicit step, factored: I - γ ∂(v, M⁻¹f)/∂(q, v), with the convex part of the stiffness.
#pragma once

#include "sim/solvers/cholesky.hpp"
#include "sim/world.hpp"

namespace wale::peers {

/// Eliminating the positions leaves (M + γ C + γ² K) z_v = M r_v - γ K r_q, z_q = r_q + γ z_v.
class ImplicitMatrix {
 public:
  /// `world` must outlive it.
  explicit ImplicitMatrix(World& world);

  /// K and C at a state.
  void assemble(const State&);
  /// For a step of γ, s. False if that is not positive definite.
  [[nodiscard]] bool factor(double gamma);
  /// (r_q, r_v) becomes (z_q, z_v).
  void solve(Eigen::Ref<Eigen::VectorXd> r) const;
  long factorizations() const { return factorizations_; }

 private:
  World& world_;
  Stiffness mass_, stiffness_, damping_, sum_;
  Cholesky cholesky_;
  double gamma_ = 0;
  long factorizations_ = 0;
};

}  // namespace wale::peers
