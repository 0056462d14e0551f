#include "sim/solvers/ordered_matrix.hpp"

#include <algorithm>

#include "sim/solvers/cholmod.hpp"

namespace wale {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

OrderedMatrix::OrderedMatrix(const Stiffness& K, const UsedBlocks& used, std::vector<int> order)
    : order_(std::move(order)) {
  std::vector<int> place(index(K.points()), -1);
  for (std::size_t k = 0; k < order_.size(); ++k) place[index(order_[k])] = static_cast<int>(k);
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const int point = order_[k];
    for (const Stiffness::Entry& entry : K.row(point))
      if (const int row = place[index(entry.column)]; row >= static_cast<int>(k) && used.has(point, entry))
        blocks_.push_back({row, entry.slot, entry.column > point});
    std::sort(blocks_.begin() + first_.back(), blocks_.end(),
              [](const Block& a, const Block& b) { return a.row < b.row; });
    first_.push_back(static_cast<int>(blocks_.size()));
  }
  rows_.reserve(9 * blocks_.size());
  for (std::size_t k = 0; k < order_.size(); ++k)
    for (int c = 0; c < 3; ++c) {
      for (int b = first_[k]; b < first_[k + 1]; ++b)
        for (int r = 0; r < 3; ++r) rows_.push_back(3 * blocks_[index(b)].row + r);
      starts_.push_back(static_cast<int>(rows_.size()));
    }
  values_.resize(rows_.size());
}

void OrderedMatrix::take(const Stiffness& K) {
  const auto points = static_cast<int>(order_.size());
#pragma omp parallel for schedule(static)
  for (int place = 0; place < points; ++place) {
    const int begin = first_[index(place)], count = first_[index(place + 1)] - begin;
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 3>> columns(&values_[9 * index(begin)], 3 * count, 3);
    for (int b = 0; b < count; ++b) {
      const Block& block = blocks_[index(begin + b)];
      if (block.transposed)
        columns.middleRows<3>(3 * b) = K.at(block.slot).transpose();
      else
        columns.middleRows<3>(3 * b) = K.at(block.slot);
    }
  }
}

cholmod_sparse OrderedMatrix::view() { return cholmod::lower_triangle(starts_, rows_, &values_); }

}  // namespace wale
