/// Forces and stiffness at one load, as root-finders are given them.
#pragma once

#include "bench/peers/methods.hpp"
#include "bench/peers/stopwatch.hpp"
#include "sim/solvers/cholesky.hpp"
#include "sim/solvers/increment.hpp"

namespace wale::peers {

/// f(x) = 0, where x is how far what may move has moved from a position: all control points of a swatch, or those of a
/// periodic fabric that do not follow others and its periods. Nothing may dissipate. Not copyable.
class Balance {
 public:
  using Vector = Eigen::Ref<Eigen::VectorXd>;
  using ConstVector = Eigen::Ref<const Eigen::VectorXd>;

  /// `world` must outlive it.
  Balance(World& world, State from);

  Eigen::Index size() const { return 3 * increment_.points(); }
  /// Brings the load, and the periods that it leads, to `t`; x counts from there.
  void load(double t);
  /// x counts from where it is now.
  void settle(const ConstVector& x) { from_ = at(x); }
  const State& from() const { return from_; }
  State at(const ConstVector& x) const;

  /// False if that is not finite, or if two yarns come so near that one move could bring them through each other.
  [[nodiscard]] bool force(const ConstVector& x, Vector f);
  /// The largest force on a control point, N.
  static double residual(const ConstVector& f);
  /// The second derivative of the energy and its convex part.
  void assemble(const ConstVector& x);
  /// Of the convex part and `shift`, N/m. False if that is not positive definite.
  [[nodiscard]] bool factor(double shift);
  /// v := (convex part + shift)⁻¹ v.
  void solve(Vector v) const;
  /// out := second derivative times v.
  void multiply(const ConstVector& v, Vector out) const;

  /// Directions in which the energy falls, at the last assemble(): none if that was at a least. For small problems, as
  /// it takes all eigenvalues.
  int ways_down() const;

  /// Says where it is, and what it took to get there.
  void conclude(Answer& answer, const Stopwatch& watch) const;

 private:
  World& world_;
  Increment increment_;
  Leeway leeway_;
  State from_;
  Points force_;
  Stiffness exact_, convex_;
  Cholesky cholesky_;
  long evaluations_ = 0, factorizations_ = 0;
};

}  // namespace wale::peers
