/// The banded mass matrix of every yarn, factored once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/cyclic_band.hpp"
#include "sim/fabric.hpp"
#include "sim/stiffness.hpp"

namespace wale {

/// The unit mass matrix M_kj = ∫ b_k b_j ds of a yarn (Ding et al. 2023, Eq. 9), weighted a segment by `weight`
/// (all ones gives Table A.2), in LAPACK's lower band storage with 3 subdiagonals: 4 rows, n + 3 columns.
Eigen::MatrixXd mass_band(const std::vector<double>& weight);

/// rho l0 M of all yarns. M is symmetric positive definite and banded, so it is factored by dpbtrf, which needs
/// half the work and storage of dgbtrf and no pivoting. In a periodic fabric a yarn's last three control points move as
/// its first three, and its two periods, the last columns, have no mass.
class Mass {
 public:
  explicit Mass(const Fabric&);
  /// That of a motion in which the points that `held` marks stay: of each run of others between them on its own.
  Mass between(const std::vector<std::uint8_t>& held) const;
  /// b := M⁻¹ b, in place; by the columns of State::q. Of a periodic fabric: the accelerations while its periods go on
  /// at the rate that they have.
  void solve(Points& b) const;
  /// M v.
  Points times(const Points& v) const;
  /// K += M, in kg.
  void add_to(Stiffness& K) const;
  /// ½ v·M v, J.
  double kinetic_energy(const Points& v) const;

 private:
  struct Band {
    int first_point = 0;
    Eigen::MatrixXd matrix, factor;
    std::optional<CyclicBand> closed = {};  // in place of `factor`, in a periodic fabric
  };
  static void solve(const CyclicBand& yarn, Eigen::Ref<Points> b);
  Mass() = default;
  std::vector<Band> yarns_;
};

}  // namespace wale
