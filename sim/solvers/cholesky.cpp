#include "sim/solvers/cholesky.hpp"

#include <algorithm>
#include <atomic>
#include <functional>

#include "sim/solvers/dense.hpp"

extern "C" void openblas_set_num_threads(int);

namespace wale {
namespace {

// Of a front, in scalars: wide enough for BLAS to be fast, narrow enough to share a front among threads.
constexpr int tile = 144;
// Blocks that are kept in the order of elimination, over those that are used.
constexpr double most_idle = 1.3;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

Cholesky::Cholesky() {
  // Threads share fronts and tiles instead, which gives the same bits always.
  openblas_set_num_threads(1);
}

/// Every front after its children; branches at the same time.
template <class Visit>
void Cholesky::upwards(const Visit& visit) const {
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t b = 0; b < elimination_.branches.size(); ++b)
    for (int f = elimination_.branches[b].first; f <= elimination_.branches[b].second; ++f) visit(f);
  for (const int f : elimination_.trunk) visit(f);
}

Eigen::Map<Eigen::MatrixXd> Cholesky::panel(int front) {
  const Front& of = elimination_.fronts[index(front)];
  return {panels_.data() + panel_at_[index(front)], 3 * of.size(), 3 * of.own};
}

Eigen::Map<const Eigen::MatrixXd> Cholesky::panel(int front) const {
  const Front& of = elimination_.fronts[index(front)];
  return {panels_.data() + panel_at_[index(front)], 3 * of.size(), 3 * of.own};
}

void Cholesky::analyse(const Stiffness& K) {
  std::vector<char> used(K.slots());
  for (std::size_t slot = 0; slot < used.size(); ++slot) used[slot] = !K.at(static_cast<int>(slot)).isZero(0);
  used_.resize(used.size());
  const auto is_covered = [](char now, char before) { return now <= before; };
  if (!elimination_.order.empty() && std::equal(used.begin(), used.end(), used_.begin(), is_covered)) return;
  // What was used before may well come back: yarns touch and part again.
  const auto now = std::count(used.begin(), used.end(), 1);
  std::transform(used.begin(), used.end(), used_.begin(), used_.begin(), std::bit_or<char>());
  if (static_cast<double>(std::count(used_.begin(), used_.end(), 1)) > most_idle * static_cast<double>(now))
    used_ = used;
  elimination_ = eliminate(K, used_);
  std::size_t size = 0;
  panel_at_.clear();
  for (const Front& front : elimination_.fronts) {
    panel_at_.push_back(size);
    size += 9 * index(front.size()) * index(front.own);
  }
  panels_.resize(static_cast<Eigen::Index>(size));
  updates_.resize(elimination_.fronts.size());
}

bool Cholesky::factor(const Stiffness& K, double shift) {
  analyse(K);
  std::atomic<bool> positive = true;
  upwards([&](int front) {
    if (!factor_front(K, shift, front)) positive = false;
  });
  return positive;
}

bool Cholesky::factor_front(const Stiffness& K, double shift, int front) {
  const Front& of = elimination_.fronts[index(front)];
  add_entries(K, shift, front);
  updates_[index(front)].setZero(3 * (of.size() - of.own), 3 * (of.size() - of.own));
  for (const int child : of.children) {
    add_child(child, front);
    updates_[index(child)].resize(0, 0);
  }
  return eliminate_own(front);
}

void Cholesky::add_entries(const Stiffness& K, double shift, int front) {
  auto columns = panel(front);
  columns.setZero();
  for (const FrontEntry& entry : elimination_.fronts[index(front)].entries) {
    auto block = columns.block<3, 3>(3 * entry.row, 3 * entry.column);
    if (entry.transposed)
      block = K.at(entry.slot).transpose();
    else
      block = K.at(entry.slot);
  }
  columns.diagonal().array() += shift;
}

void Cholesky::add_child(int child, int front) {
  const std::vector<Run>& runs = elimination_.fronts[index(child)].into_parent;
  const Eigen::MatrixXd& update = updates_[index(child)];
  const int own = 3 * elimination_.fronts[index(front)].own;
  auto columns = panel(front);
  Eigen::MatrixXd& rest = updates_[index(front)];
#pragma omp parallel for schedule(dynamic, 1) if (update.cols() > tile)
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (int k = 0; k < 3 * runs[r].length; ++k) {
      const int from = 3 * runs[r].from + k, to = 3 * runs[r].to + k;
      const auto add = [&](int source, int target, int length) {
        if (to < own)
          columns.col(to).segment(target, length) += update.col(from).segment(source, length);
        else
          rest.col(to - own).segment(target - own, length) += update.col(from).segment(source, length);
      };
      add(from, to, 3 * runs[r].length - k);
      for (std::size_t below = r + 1; below < runs.size(); ++below)
        add(3 * runs[below].from, 3 * runs[below].to, 3 * runs[below].length);
    }
}

/// Tile by tile: factor the diagonal, divide the rows below by it, take their products from the columns to the right.
bool Cholesky::eliminate_own(int front) {
  auto columns = panel(front);
  Eigen::MatrixXd& rest = updates_[index(front)];
  const int n = static_cast<int>(columns.rows()), own = static_cast<int>(columns.cols());
  for (int k = 0; k < own; k += tile) {
    const int width = std::min(tile, own - k), after = k + width;
    if (!dense::factor(width, &columns(k, k), n)) return false;
    const int tiles = (n - after + tile - 1) / tile;
#pragma omp parallel for schedule(static) if (tiles > 1)
    for (int t = 0; t < tiles; ++t) {
      const int row = after + t * tile;
      dense::divide(std::min(tile, n - row), width, &columns(k, k), n, &columns(row, k), n);
    }
    // The columns to the right are own ones first, then those of the update.
    const int own_tiles = (own - after + tile - 1) / tile, all_tiles = own_tiles + (n - own + tile - 1) / tile;
#pragma omp parallel for schedule(dynamic, 1) if (all_tiles > 1)
    for (int t = 0; t < all_tiles; ++t) {
      const bool mine = t < own_tiles;
      const int column = mine ? after + t * tile : own + (t - own_tiles) * tile;
      const int wide = std::min(tile, (mine ? own : n) - column), below = n - column - wide;
      double* target = mine ? &columns(column, column) : &rest(column - own, column - own);
      const int stride = mine ? n : n - own;
      dense::subtract_square(wide, width, &columns(column, k), n, target, stride);
      if (below > 0)
        dense::subtract_product(below, wide, width, &columns(column + wide, k), n, &columns(column, k), n,
                                target + wide, stride);
    }
  }
  return true;
}

void Cholesky::solve_forward(int front, Eigen::VectorXd& x, std::vector<Eigen::VectorXd>& carried) const {
  const Front& of = elimination_.fronts[index(front)];
  const int own = 3 * of.own, rest = 3 * (of.size() - of.own);
  const auto columns = panel(front);
  Eigen::VectorXd& carry = carried[index(front)];
  carry.setZero(rest);
  auto mine = x.segment(3 * of.rows.front(), own);
  for (const int child : of.children) {
    const Eigen::VectorXd& from = carried[index(child)];
    for (const Run& run : elimination_.fronts[index(child)].into_parent)
      for (int k = 0; k < 3 * run.length; ++k) {
        const int to = 3 * run.to + k;
        (to < own ? mine[to] : carry[to - own]) += from[3 * run.from + k];
      }
  }
  columns.topRows(own).triangularView<Eigen::Lower>().solveInPlace(mine);
  carry.noalias() -= columns.bottomRows(rest) * mine;
}

void Cholesky::solve_backward(int front, Eigen::VectorXd& x) const {
  const Front& of = elimination_.fronts[index(front)];
  const int own = 3 * of.own, rest = 3 * (of.size() - of.own);
  const auto columns = panel(front);
  Eigen::VectorXd below(rest);
  for (int k = of.own; k < of.size(); ++k) below.segment<3>(3 * (k - of.own)) = x.segment<3>(3 * of.rows[index(k)]);
  auto mine = x.segment(3 * of.rows.front(), own);
  mine.noalias() -= columns.bottomRows(rest).transpose() * below;
  columns.topRows(own).triangularView<Eigen::Lower>().transpose().solveInPlace(mine);
}

void Cholesky::solve(Eigen::VectorXd& x) const {
  const std::vector<int>& order = elimination_.order;
  Eigen::VectorXd ordered(x.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    ordered.segment<3>(3 * static_cast<Eigen::Index>(k)) = x.segment<3>(3 * order[k]);
  std::vector<Eigen::VectorXd> carried(elimination_.fronts.size());
  upwards([&](int front) { solve_forward(front, ordered, carried); });
  for (auto f = elimination_.trunk.rbegin(); f != elimination_.trunk.rend(); ++f) solve_backward(*f, ordered);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t b = 0; b < elimination_.branches.size(); ++b)
    for (int f = elimination_.branches[b].second; f >= elimination_.branches[b].first; --f) solve_backward(f, ordered);
  for (std::size_t k = 0; k < order.size(); ++k)
    x.segment<3>(3 * order[k]) = ordered.segment<3>(3 * static_cast<Eigen::Index>(k));
}

}  // namespace wale
