#include "bench/peers/implicit_matrix.hpp"

#include <algorithm>

namespace wale::peers {
namespace {

Stiffness mass_blocks(const Fabric& fabric) {
  Stiffness blocks(static_cast<int>(fabric.points.cols()));
  for (const Yarn& yarn : fabric.yarns) {
    std::vector<double> weight;
    for (int i = yarn.first_segment; i < yarn.first_segment + yarn.segments; ++i)
      weight.push_back(fabric.material_of(i).linear_density * fabric.segment(i).length);
    const Eigen::MatrixXd band = mass_band(weight);
    for (int j = 0; j < yarn.points(); ++j)
      for (int i = j; i < std::min(j + 4, yarn.points()); ++i)
        blocks.add(yarn.first_point + j, yarn.first_point + i, band(i - j, j) * Mat3::Identity());
  }
  return blocks;
}

/// to += factor * of.
void add(const Stiffness& of, double factor, Stiffness& to) {
  for (int i = 0; i < of.points(); ++i)
    for (const Stiffness::Entry& entry : of.row(i))
      if (entry.column >= i) to.add(i, entry.column, factor * of.at(entry.slot));
}

}  // namespace

ImplicitMatrix::ImplicitMatrix(World& world)
    : world_(world),
      mass_(mass_blocks(world.fabric())),
      stiffness_(mass_.points()),
      damping_(mass_.points()),
      sum_(mass_.points()) {}

void ImplicitMatrix::assemble(const State& at) {
  world_.prepare(at);
  Load load{.damping = &damping_, .convex = &stiffness_};
  world_.evaluate(at, load);
}

bool ImplicitMatrix::factor(double gamma) {
  gamma_ = gamma;
  ++factorizations_;
  sum_.clear();
  add(mass_, 1 / (gamma * gamma), sum_);
  add(damping_, 1 / gamma, sum_);
  add(stiffness_, 1, sum_);
  return cholesky_.factor(sum_, 0);
}

void ImplicitMatrix::solve(Eigen::Ref<Eigen::VectorXd> r) const {
  const Eigen::Index half = r.size() / 2;
  const Eigen::VectorXd r_q = r.head(half), r_v = r.tail(half);
  Eigen::VectorXd z_v, pulled;
  mass_.multiply(r_v, z_v);
  stiffness_.multiply(r_q, pulled);
  z_v = (z_v - gamma_ * pulled) / (gamma_ * gamma_);
  cholesky_.solve(z_v);
  r.head(half) = r_q + gamma_ * z_v;
  r.tail(half) = z_v;
}

}  // namespace wale::peers
