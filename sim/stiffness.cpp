#include "sim/stiffness.hpp"

#include <algorithm>

namespace wale {

Stiffness::Stiffness(int points) : columns_(static_cast<std::size_t>(points)) {}

void Stiffness::clear() { std::fill(values_.begin(), values_.end(), Mat3(Mat3::Zero())); }

void Stiffness::forget() {
  for (auto& column : columns_) column.clear();
  values_.clear();
  admitted_.clear();
  ++version_;
}

int Stiffness::slot(int i, int j) {
  assert(i <= j);
  auto& column = columns_[static_cast<std::size_t>(j)];
  const auto at =
      std::lower_bound(column.begin(), column.end(), i, [](const Entry& entry, int row) { return entry.row < row; });
  if (at != column.end() && at->row == i) return at->slot;
  const int made = static_cast<int>(values_.size());
  column.insert(at, {i, made});
  values_.emplace_back(Mat3::Zero());
  ++version_;
  return made;
}

void Stiffness::compress(Compressed& out, long& out_version) const {
  if (out_version != version_) {
    out.start.assign(1, 0);
    out.row.clear();
    for (int j = 0; j < points(); ++j) {
      for (int c = 0; c < 3; ++c) {
        for (const Entry& entry : columns_[static_cast<std::size_t>(j)])
          for (int r = 0; r < (entry.row == j ? c + 1 : 3); ++r) out.row.push_back(3 * entry.row + r);
        out.start.push_back(static_cast<int>(out.row.size()));
      }
    }
    out.value.resize(out.row.size());
    out_version = version_;
  }
  std::size_t at = 0;
  for (int j = 0; j < points(); ++j)
    for (int c = 0; c < 3; ++c)
      for (const Entry& entry : columns_[static_cast<std::size_t>(j)])
        for (int r = 0; r < (entry.row == j ? c + 1 : 3); ++r)
          out.value[at++] = values_[static_cast<std::size_t>(entry.slot)](r, c);
}

void Stiffness::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  y.setZero(x.size());
  for (int j = 0; j < points(); ++j)
    for (const Entry& entry : columns_[static_cast<std::size_t>(j)]) {
      const Mat3& block = values_[static_cast<std::size_t>(entry.slot)];
      y.segment<3>(3 * entry.row) += block * x.segment<3>(3 * j);
      if (entry.row != j) y.segment<3>(3 * j) += block.transpose() * x.segment<3>(3 * entry.row);
    }
}

}  // namespace wale
