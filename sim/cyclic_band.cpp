#include "sim/cyclic_band.hpp"

#include <Eigen/LU>
#include <stdexcept>

#include "sim/lapack.hpp"

namespace wale {

CyclicBand::CyclicBand(const Eigen::MatrixXd& open) {
  const Eigen::Index n = open.cols() - 3, others = n - 3, below = open.rows();
  if (others < 1) throw std::invalid_argument("a closed yarn has too few segments");
  band_ = Eigen::MatrixXd::Zero(below, others);
  mixed_.setZero(3, others);
  last_.setZero();
  const auto add = [&](Eigen::Index i, Eigen::Index j, double value) {
    if (i < others && j < others) band_(std::abs(i - j), std::min(i, j)) += value;
    if (i >= others && j < others) mixed_(i - others, j) += value;
    if (j >= others && i < others) mixed_(j - others, i) += value;
    if (i < others || j < others) return;
    last_(i - others, j - others) += value;
    if (i != j) last_(j - others, i - others) += value;
  };
  for (Eigen::Index j = 0; j < n + 3; ++j)
    for (Eigen::Index k = 0; k < below && j + k < n + 3; ++k) add((j + k) % n, j % n, open(k, j));
  if (lapack::dpbtrf(band_) != 0) throw std::invalid_argument("a closed yarn's matrix is not positive");
  lifted_ = mixed_.transpose();
  lapack::dpbtrs(band_, lifted_);
  last_ = (last_ - mixed_ * lifted_).inverse().eval();
}

void CyclicBand::solve(Eigen::MatrixXd& b) const {
  const Eigen::Index others = b.rows() - 3;
  Eigen::MatrixXd above = b.topRows(others);
  lapack::dpbtrs(band_, above);
  const Eigen::MatrixXd last = last_ * (b.bottomRows<3>() - mixed_ * above);
  b.topRows(others) = above - lifted_ * last;
  b.bottomRows<3>() = last;
}

}  // namespace wale
