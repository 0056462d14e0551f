#include "sim/solvers/supernodes.hpp"

#include <algorithm>
#include <array>

#include "sim/solvers/cholmod.hpp"

namespace wale {
namespace {

// Supernodes of so few points are joined with what follows if the zeros in them are at most 80, 10 and 5 % (CHOLMOD's
// limits); wider ones make a factor larger that takes as long.
constexpr std::array<std::size_t, 3> joined_points{1, 4, 8};

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The used blocks between points of an order, below the diagonal and on it.
struct Graph {
  std::vector<int> starts{0}, rows;

  Graph(const Stiffness& K, const UsedBlocks& used, const std::vector<int>& order) {
    std::vector<int> place(index(K.points()), -1);
    for (std::size_t k = 0; k < order.size(); ++k) place[index(order[k])] = static_cast<int>(k);
    for (std::size_t k = 0; k < order.size(); ++k) {
      for (const Stiffness::Entry& entry : K.row(order[k]))
        if (const int row = place[index(entry.column)]; row >= static_cast<int>(k) && used.has(order[k], entry))
          rows.push_back(row);
      std::sort(rows.begin() + starts.back(), rows.end());
      starts.push_back(static_cast<int>(rows.size()));
    }
  }
  cholmod_sparse view() { return cholmod::lower_triangle(starts, rows, nullptr); }
};

/// The same fill in an order in which every branch is complete before the next begins, so that more columns with the
/// same rows are neighbours, and little that waits is held at a time.
std::vector<int> branch_by_branch(const Stiffness& K, const UsedBlocks& used, const std::vector<int>& part) {
  Graph graph(K, used, part);
  std::vector<int> order;
  for (const int place : cholmod::order_of(graph.view(), CHOLMOD_NATURAL)) order.push_back(part[index(place)]);
  return order;
}

}  // namespace

Supernodes::Supernodes(const Stiffness& K, const UsedBlocks& used, const std::vector<int>& part,
                       const std::vector<int>& border)
    : order_(branch_by_branch(K, used, part)) {
  order_.insert(order_.end(), border.begin(), border.end());
  Graph graph(K, used, order_);
  cholmod::Common common;
  common->supernodal = CHOLMOD_SUPERNODAL;
  common->method[0].ordering = CHOLMOD_NATURAL;
  common->postorder = 0;
  std::copy(joined_points.begin(), joined_points.end(), common->nrelax);
  cholmod_sparse view = graph.view();
  const cholmod::Factor factor = common.analyse(view);
  const auto* first = static_cast<const int*>(factor->super);
  const auto* starts = static_cast<const int*>(factor->pi);
  const auto* rows = static_cast<const int*>(factor->s);
  const int own = static_cast<int>(part.size());
  for (std::size_t s = 0; s < factor->nsuper && first[s] < own; ++s) {
    first_.push_back(first[s]);
    row_starts_.push_back(index(starts[s]));
  }
  first_.push_back(own);  // a supernode may reach into the border, which is not eliminated here
  row_starts_.push_back(index(starts[first_.size() - 1]));
  rows_.assign(rows, rows + row_starts_.back());
  find_parents();
}

void Supernodes::find_parents() {
  parent_.assign(first_.size() - 1, -1);
  for (int s = 0; s < count(); ++s) {
    if (width(s) == height(s)) continue;
    const auto above = std::upper_bound(first_.begin(), first_.end(), rows(s)[width(s)]);
    if (above != first_.end()) parent_[index(s)] = static_cast<int>(above - first_.begin()) - 1;
  }
}

}  // namespace wale
