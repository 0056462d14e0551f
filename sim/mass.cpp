#include "sim/mass.hpp"

#include <algorithm>
#include <stdexcept>

#include "sim/lapack.hpp"
#include "sim/spline.hpp"

namespace wale {

namespace {

/// ∫ b_k b_j ds over one segment: degree 6, which 4 Gauss nodes integrate exactly.
Eigen::Matrix4d segment_mass() {
  Eigen::Matrix4d mass = Eigen::Matrix4d::Zero();
  for (const GaussNode& node : gauss(4)) {
    const Basis at = basis(node.s);
    const Eigen::Map<const Eigen::Vector4d> b(at.value.data());
    mass += node.weight * b * b.transpose();
  }
  return mass;
}

/// y = A x for a symmetric A in lower band storage, on three coordinates at once.
void add_product(const Eigen::MatrixXd& band, const Eigen::Ref<const Points>& x, Eigen::Ref<Points> y) {
  const Eigen::Index n = band.cols(), below = band.rows();
  for (Eigen::Index j = 0; j < n; ++j) {
    y.col(j) += band(0, j) * x.col(j);
    for (Eigen::Index k = 1; k < below && j + k < n; ++k) {
      y.col(j + k) += band(k, j) * x.col(j);
      y.col(j) += band(k, j) * x.col(j + k);
    }
  }
}

}  // namespace

Eigen::MatrixXd mass_band(const std::vector<double>& weight) {
  const Eigen::Matrix4d unit = segment_mass();
  const auto segments = static_cast<Eigen::Index>(weight.size());
  Eigen::MatrixXd band = Eigen::MatrixXd::Zero(4, segments + 3);
  for (Eigen::Index i = 0; i < segments; ++i)
    for (Eigen::Index column = 0; column < 4; ++column)
      for (Eigen::Index row = column; row < 4; ++row)
        band(row - column, i + column) += weight[static_cast<std::size_t>(i)] * unit(row, column);
  return band;
}

Mass::Mass(const Fabric& fabric) {
  for (const Yarn& yarn : fabric.yarns) {
    std::vector<double> weight;
    for (int i = yarn.first_segment; i < yarn.first_segment + yarn.segments; ++i)
      weight.push_back(fabric.material_of(i).linear_density * fabric.segment(i).length);
    Band band{yarn.first_point, mass_band(weight), {}};
    band.factor = band.matrix;
    if (lapack::dpbtrf(band.factor) != 0)
      throw std::invalid_argument("a yarn's mass is not positive: linear density and rest length must be");
    if (fabric.cell) band.closed.emplace(band.matrix);
    yarns_.push_back(std::move(band));
  }
}

Mass Mass::between(const std::vector<std::uint8_t>& held) const {
  Mass part;
  for (const Band& yarn : yarns_) {
    const auto begin = held.begin() + yarn.first_point, end = begin + yarn.matrix.cols();
    for (auto first = std::find(begin, end, 0); first != end;) {
      const auto last = std::find(first, end, 1);
      Band run{static_cast<int>(first - held.begin()), yarn.matrix.middleCols(first - begin, last - first), {}};
      run.factor = run.matrix;
      lapack::dpbtrf(run.factor);
      part.yarns_.push_back(std::move(run));
      first = std::find(last, end, 0);
    }
  }
  return part;
}

void Mass::solve(Points& b) const {
  Eigen::MatrixXd columns;
  for (const Band& yarn : yarns_) {
    auto part = b.middleCols(yarn.first_point, yarn.factor.cols());
    if (yarn.closed) {
      solve(*yarn.closed, part);
      continue;
    }
    columns = part.transpose();
    lapack::dpbtrs(yarn.factor, columns);
    part = columns.transpose();
  }
  if (!yarns_.empty() && yarns_.front().closed) b.rightCols<2>().setZero();
}

void Mass::solve(const CyclicBand& yarn, Eigen::Ref<Points> b) {
  const Eigen::Index segments = b.cols() - 3;
  b.leftCols<3>() += b.rightCols<3>();
  Eigen::MatrixXd columns = b.leftCols(segments).transpose();
  yarn.solve(columns);
  b.leftCols(segments) = columns.transpose();
  b.rightCols<3>() = b.leftCols<3>();
}

Points Mass::times(const Points& v) const {
  Points product = Points::Zero(3, v.cols());
  for (const Band& yarn : yarns_) {
    const Eigen::Index count = yarn.matrix.cols();
    add_product(yarn.matrix, v.middleCols(yarn.first_point, count), product.middleCols(yarn.first_point, count));
  }
  return product;
}

void Mass::add_to(Stiffness& K) const {
  for (const Band& yarn : yarns_)
    for (int j = 0; j < yarn.matrix.cols(); ++j)
      for (int k = 0; k < yarn.matrix.rows() && j + k < yarn.matrix.cols(); ++k)
        K.add(yarn.first_point + j, yarn.first_point + j + k, yarn.matrix(k, j) * Mat3::Identity());
}

double Mass::kinetic_energy(const Points& v) const { return 0.5 * v.cwiseProduct(times(v)).sum(); }

}  // namespace wale
