/// Small worlds as dense matrices: stiffness and mass on the motions that the clamps allow.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include "sim/world.hpp"
#include "tests/support/finite_difference.hpp"

namespace wale {

/// The columns span all motions that the constraints of `world` allow.
inline Eigen::MatrixXd free_motions(const World& world) {
  const Eigen::Index n = world.fabric().points.size();
  if (world.constraints().empty()) return Eigen::MatrixXd::Identity(n, n);
  return Eigen::FullPivLU<Eigen::MatrixXd>(world.constraints().rows()).kernel();
}

inline Eigen::MatrixXd dense_stiffness(World& world, const State& at) {
  Stiffness stiffness(static_cast<int>(at.q.cols()));
  Load load{.stiffness = &stiffness};
  world.prepare(at);
  world.evaluate(at, load);
  return dense(stiffness);
}

inline Eigen::MatrixXd dense_mass(const World& world) {
  const Eigen::Index n = world.fabric().points.size();
  Eigen::MatrixXd mass(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Points unit = Eigen::VectorXd::Unit(n, i).reshaped(3, n / 3);
    mass.col(i) = world.mass().times(unit).reshaped();
  }
  return mass;
}

/// The squared angular frequencies of small vibrations about `at`, ascending, 1/s².
inline Eigen::VectorXd squared_frequencies(World& world, const State& at) {
  const Eigen::MatrixXd z = free_motions(world);
  const Eigen::MatrixXd k = z.transpose() * dense_stiffness(world, at) * z, m = z.transpose() * dense_mass(world) * z;
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(k, m, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace wale
