#include "sim/solvers/part_factor.hpp"

#include "sim/solvers/fronts.hpp"

namespace wale {

PartFactor::PartFactor(const Stiffness& K, const UsedBlocks& used, const std::vector<int>& part,
                       const std::vector<int>& border, Precision precision)
    : supernodes_(K, used, part, border), sequence_(supernodes_), panels_(supernodes_, precision) {}

double PartFactor::factor_work() const {
  double work = 0;
  for (int s = 0; s < supernodes_.count(); ++s)
    for (int c = 0; c < 3 * supernodes_.width(s); ++c) {
      const double height = 3 * supernodes_.height(s) - c;
      work += height * height;
    }
  return work;
}

bool PartFactor::factor(const Stiffness& K, double shift, const UsedBlocks& used, LowerTriangle& border) {
  return factor_by_fronts(K, shift, used, supernodes_, sequence_, panels_, border);
}

void PartFactor::forward(const Eigen::VectorXd& x, Eigen::VectorXd& border) {
  const std::vector<int>& order = supernodes_.order();
  const int own = supernodes_.own();
  y_.setZero(3 * static_cast<Eigen::Index>(order.size()));
  for (int k = 0; k < own; ++k) y_.segment<3>(3 * k) = x.segment<3>(3 * order[static_cast<std::size_t>(k)]);
  panels_.forward(y_);
  border += y_.tail(border.size());
}

void PartFactor::backward(const Eigen::VectorXd& border, Eigen::VectorXd& x) {
  const std::vector<int>& order = supernodes_.order();
  y_.tail(border.size()) = border;
  panels_.backward(y_);
  for (int k = 0; k < supernodes_.own(); ++k)
    x.segment<3>(3 * order[static_cast<std::size_t>(k)]) = y_.segment<3>(3 * k);
}

}  // namespace wale
