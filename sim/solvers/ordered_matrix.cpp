#include "sim/solvers/ordered_matrix.hpp"

#include <algorithm>
#include <functional>

#include "sim/solvers/cholmod.hpp"

namespace wale {
namespace {

// Blocks that are kept in the pattern, over those that are used.
constexpr double most_idle = 1.3;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

bool OrderedMatrix::update(const Stiffness& K) {
  const bool is_new = find_used(K);
  if (is_new) {
    find_order(K);
    lay_out(K);
  }
  copy_values(K);
  return is_new;
}

cholmod_sparse OrderedMatrix::view() { return cholmod::lower_triangle(starts_, rows_, &values_); }

/// True if blocks are used that were not.
bool OrderedMatrix::find_used(const Stiffness& K) {
  std::vector<char> used(K.slots());
  for (std::size_t slot = 0; slot < used.size(); ++slot) used[slot] = !K.at(static_cast<int>(slot)).isZero(0);
  used_.resize(used.size());
  const auto is_covered = [](char now, char before) { return now <= before; };
  if (!order_.empty() && std::equal(used.begin(), used.end(), used_.begin(), is_covered)) return false;
  // What was used before may well come back: yarns touch and part again.
  const auto now = std::count(used.begin(), used.end(), 1);
  std::transform(used.begin(), used.end(), used_.begin(), used_.begin(), std::bit_or<char>());
  if (static_cast<double>(std::count(used_.begin(), used_.end(), 1)) > most_idle * static_cast<double>(now))
    used_ = used;
  return true;
}

bool OrderedMatrix::is_used(int point, const Stiffness::Entry& entry) const {
  return entry.column == point || used_[index(entry.slot)];
}

/// By minimum degree on the graph of points: nine times fewer entries than the graph of coordinates.
void OrderedMatrix::find_order(const Stiffness& K) {
  std::vector<int> start{0}, row;
  for (int j = 0; j < K.points(); ++j) {
    for (const Stiffness::Entry& entry : K.row(j))
      if (entry.column >= j && is_used(j, entry)) row.push_back(entry.column);
    start.push_back(static_cast<int>(row.size()));
  }
  cholmod::Common common;
  common->supernodal = CHOLMOD_SIMPLICIAL;  // only the order is wanted
  common->method[0].ordering = CHOLMOD_AMD;
  cholmod_sparse graph = cholmod::lower_triangle(start, row, nullptr);
  const cholmod::Factor factor = common.analyse(graph);
  const auto* order = static_cast<const int*>(factor->Perm);
  order_.assign(order, order + K.points());
}

void OrderedMatrix::lay_out(const Stiffness& K) {
  std::vector<int> place(order_.size());
  for (std::size_t k = 0; k < order_.size(); ++k) place[index(order_[k])] = static_cast<int>(k);
  first_.assign(1, 0);
  starts_.assign(1, 0);
  blocks_.clear();
  rows_.clear();
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const int point = order_[k];
    for (const Stiffness::Entry& entry : K.row(point))
      if (const int row = place[index(entry.column)]; row >= static_cast<int>(k) && is_used(point, entry))
        blocks_.push_back({row, entry.slot, entry.column > point});
    const auto begin = blocks_.begin() + first_.back();
    std::sort(begin, blocks_.end(), [](const Block& a, const Block& b) { return a.row < b.row; });
    for (int c = 0; c < 3; ++c) {
      for (auto block = begin; block != blocks_.end(); ++block)
        for (int r = 0; r < 3; ++r) rows_.push_back(3 * block->row + r);
      starts_.push_back(static_cast<int>(rows_.size()));
    }
    first_.push_back(static_cast<int>(blocks_.size()));
  }
  values_.resize(rows_.size());
}

void OrderedMatrix::copy_values(const Stiffness& K) {
#pragma omp parallel for schedule(static)
  for (int place = 0; place < K.points(); ++place) {
    const int begin = first_[index(place)], count = first_[index(place + 1)] - begin;
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 3>> columns(&values_[index(9 * begin)], 3 * count, 3);
    for (int b = 0; b < count; ++b) {
      const Block& block = blocks_[index(begin + b)];
      if (block.transposed)
        columns.middleRows<3>(3 * b) = K.at(block.slot).transpose();
      else
        columns.middleRows<3>(3 * b) = K.at(block.slot);
    }
  }
}

}  // namespace wale
