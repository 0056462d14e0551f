#include "sim/constraints.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "sim/spline.hpp"

namespace wale {

namespace {

/// One row: the component along `along` of Σ weight_k q_(first + k).
Eigen::VectorXd row(Eigen::Index points, int first, const std::array<double, 4>& weight, const Vec3& along) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(3 * points);
  for (int k = 0; k < 4; ++k) result.segment<3>(3 * (first + k)) = weight[static_cast<std::size_t>(k)] * along;
  return result;
}

}  // namespace

Constraints::Constraints(const Fabric& fabric, const std::vector<Clamp>& clamps, const Points& q) {
  std::vector<Eigen::VectorXd> rows;
  for (const Clamp& clamp : clamps) {
    const Yarn& yarn = fabric.yarns[static_cast<std::size_t>(clamp.yarn)];
    const int first = yarn.first_point + (clamp.at_end ? yarn.segments - 1 : 0);
    const Basis end = basis(clamp.at_end ? 1.0 : 0.0);
    if (clamp.position)
      for (int axis = 0; axis < 3; ++axis) rows.push_back(row(q.cols(), first, end.value, Vec3::Unit(axis)));
    if (clamp.direction) {
      const Vec3 tangent = combine(q, first, end.first).normalized();
      const Vec3 normal = tangent.unitOrthogonal();
      rows.push_back(row(q.cols(), first, end.first, normal));
      rows.push_back(row(q.cols(), first, end.first, tangent.cross(normal)));
    }
  }
  rows_.resize(static_cast<Eigen::Index>(rows.size()), 3 * q.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) rows_.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
}

void Constraints::project(Eigen::VectorXd& x, const std::function<void(Eigen::VectorXd&)>& solve) const {
  if (empty()) return;
  Eigen::MatrixXd lifted(x.size(), rows_.rows());  // A⁻¹ Cᵀ
  Eigen::VectorXd column;
  for (Eigen::Index i = 0; i < rows_.rows(); ++i) {
    column = rows_.row(i).transpose();
    solve(column);
    lifted.col(i) = column;
  }
  const Eigen::MatrixXd schur = rows_ * lifted;
  // Least squares, so that a clamp named twice does no harm.
  const Eigen::VectorXd multipliers = schur.completeOrthogonalDecomposition().solve(rows_ * x);
  x -= lifted * multipliers;
}

}  // namespace wale
