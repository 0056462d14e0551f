#include "sim/solvers/part_factor.hpp"

#include <algorithm>

#include "sim/lapack.hpp"

namespace wale {
namespace {

std::vector<int> joined(std::vector<int> first, const std::vector<int>& last) {
  first.insert(first.end(), last.begin(), last.end());
  return first;
}

}  // namespace

PartFactor::PartFactor(const Stiffness& K, const UsedBlocks& used, const std::vector<int>& part,
                       const std::vector<int>& border)
    : matrix_(K, used, joined(part, border)),
      own_(3 * static_cast<int>(part.size())),
      x_(3 * static_cast<Eigen::Index>(part.size() + border.size())) {
  common_->supernodal = CHOLMOD_SUPERNODAL;
  // The points lie in their order already, so CHOLMOD reads the matrix where it is instead of permuting a copy.
  common_->method[0].ordering = CHOLMOD_NATURAL;
  common_->postorder = 0;
  cholmod_sparse view = matrix_.view();
  factor_ = common_.analyse(view);
  work_ = common_->fl;
}

PartFactor::~PartFactor() {
  for (cholmod_dense* dense : {solution_, y_, e_}) cholmod_free_dense(&dense, common_.get());
}

PartFactor::Status PartFactor::factor(const Stiffness& K, double shift) {
  matrix_.take(K);
  cholmod_sparse view = matrix_.view();
  double beta[2] = {shift, 0};
  const cholmod::OneThread guard;
  cholmod_factorize_p(&view, beta, nullptr, 0, factor_.get(), common_.get());
  if (common_->status == CHOLMOD_OUT_OF_MEMORY) return Status::no_memory;
  return common_->status == CHOLMOD_OK && factor_->minor == factor_->n ? Status::good : Status::indefinite;
}

/// Calls act(column, row, value) for what N has below and on its diagonal, by the coordinates of the border.
template <class Do>
void PartFactor::each_of_border(const Do& act) const {
  const auto* super = static_cast<const int*>(factor_->super);
  const auto* row_starts = static_cast<const int*>(factor_->pi);
  const auto* value_starts = static_cast<const int*>(factor_->px);
  const auto* rows = static_cast<const int*>(factor_->s);
  const auto* values = static_cast<const double*>(factor_->x);
  for (auto s = factor_->nsuper; s-- > 0 && super[s + 1] > own_;) {
    const int first = super[s], height = row_starts[s + 1] - row_starts[s];
    for (int column = std::max(first, own_); column < super[s + 1]; ++column)
      for (int i = column - first; i < height; ++i)
        act(column - own_, rows[row_starts[s] + i] - own_,
            values[value_starts[s] + i + std::ptrdiff_t{column - first} * height]);
  }
}

Eigen::MatrixXd PartFactor::left_of_border() const {
  const Eigen::Index size = x_.size() - own_;
  Eigen::MatrixXd reversed = Eigen::MatrixXd::Zero(size, size);  // which makes N an upper triangle, as LAPACK wants it
  each_of_border([&](int column, int row, double value) { reversed(size - 1 - row, size - 1 - column) = value; });
  lapack::dlauum(reversed);
  return reversed;
}

PartFactor::Status PartFactor::solve(int system) {
  cholmod_dense b{};
  b.nrow = b.d = b.nzmax = static_cast<std::size_t>(x_.size());
  b.ncol = 1;
  b.x = x_.data();
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  const cholmod::OneThread guard;
  if (!cholmod_solve2(system, factor_.get(), &b, nullptr, &solution_, nullptr, &y_, &e_, common_.get()))
    return Status::no_memory;
  x_ = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(solution_->x), x_.size());
  return Status::good;
}

PartFactor::Status PartFactor::forward(const Eigen::VectorXd& x, Eigen::VectorXd& border) {
  const std::vector<int>& order = matrix_.order();
  for (int k = 0; k < own_ / 3; ++k) x_.segment<3>(3 * k) = x.segment<3>(3 * order[static_cast<std::size_t>(k)]);
  x_.tail(x_.size() - own_).setZero();
  const Status status = solve(CHOLMOD_L);  // (L⁻¹ x; -N⁻¹ M L⁻¹ x)
  each_of_border([&](int column, int row, double value) { border[row] += value * x_[own_ + column]; });
  return status;
}

PartFactor::Status PartFactor::backward(const Eigen::VectorXd& border, Eigen::VectorXd& x) {
  x_.tail(x_.size() - own_).setZero();
  each_of_border([&](int column, int row, double value) { x_[own_ + column] += value * border[row]; });
  const Status status = solve(CHOLMOD_Lt);
  const std::vector<int>& order = matrix_.order();
  for (int k = 0; k < own_ / 3; ++k) x.segment<3>(3 * order[static_cast<std::size_t>(k)]) = x_.segment<3>(3 * k);
  return status;
}

}  // namespace wale
