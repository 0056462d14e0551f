#include "sim/solvers/elimination.hpp"

#include <cholmod.h>

#include <algorithm>
#include <memory>
#include <new>
#include <span>

namespace wale {
namespace {

// Branches are cut until none holds more than this share of the work.
constexpr double largest_branch = 1.0 / 12;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// CHOLMOD's analysis of the upper triangle of the graph of points.
class Analysis {
 public:
  Analysis(const Stiffness& K, const std::vector<char>& used) {
    std::vector<int> start{0}, row;
    for (int j = 0; j < K.points(); ++j) {
      for (const Stiffness::Entry& entry : K.row(j))
        if (entry.column == j || (entry.column < j && used[index(entry.slot)])) row.push_back(entry.column);
      start.push_back(static_cast<int>(row.size()));
    }
    cholmod_sparse graph{};
    graph.nrow = graph.ncol = index(K.points());
    graph.nzmax = row.size();
    graph.p = start.data();
    graph.i = row.data();
    graph.stype = 1;  // the upper triangle is stored
    graph.itype = CHOLMOD_INT;
    graph.xtype = CHOLMOD_PATTERN;
    graph.sorted = 1;
    graph.packed = 1;
    cholmod_start(&common_);
    common_.print = 0;
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_AMD;
    factor_ = cholmod_analyze(&graph, &common_);
    if (!factor_) {
      cholmod_finish(&common_);
      throw std::bad_alloc();
    }
  }
  ~Analysis() {
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }
  Analysis(const Analysis&) = delete;
  Analysis& operator=(const Analysis&) = delete;

  std::span<const int> order() const { return {static_cast<const int*>(factor_->Perm), factor_->n}; }
  int fronts() const { return static_cast<int>(factor_->nsuper); }
  int own(int front) const { return first(front + 1) - first(front); }
  std::span<const int> rows(int front) const {
    const auto* begin = static_cast<const int*>(factor_->pi);
    return {static_cast<const int*>(factor_->s) + begin[front], index(begin[front + 1] - begin[front])};
  }

 private:
  int first(int front) const { return static_cast<const int*>(factor_->super)[front]; }

  cholmod_common common_;
  cholmod_factor* factor_;
};

void link(std::vector<Front>& fronts, int points) {
  std::vector<int> front_of(index(points));  // by place in the order
  for (int f = 0; f < static_cast<int>(fronts.size()); ++f)
    for (int k = 0; k < fronts[index(f)].own; ++k) front_of[index(fronts[index(f)].rows[index(k)])] = f;
  for (int f = 0; f < static_cast<int>(fronts.size()); ++f) {
    Front& front = fronts[index(f)];
    if (front.own == front.size()) continue;
    front.parent = front_of[index(front.rows[index(front.own)])];
    Front& parent = fronts[index(front.parent)];
    parent.children.push_back(f);
    int at = 0;
    for (int k = front.own; k < front.size(); ++k) {
      while (parent.rows[index(at)] != front.rows[index(k)]) ++at;
      auto& runs = front.into_parent;
      if (!runs.empty() && runs.back().to + runs.back().length == at)
        ++runs.back().length;
      else
        runs.push_back({k - front.own, at, 1});
    }
  }
}

void place_entries(const Stiffness& K, const std::vector<char>& used, Elimination& out) {
  std::vector<int> place(out.order.size()), row_of(out.order.size());
  for (std::size_t k = 0; k < out.order.size(); ++k) place[index(out.order[k])] = static_cast<int>(k);
  for (Front& front : out.fronts) {
    for (int r = 0; r < front.size(); ++r) row_of[index(front.rows[index(r)])] = r;
    for (int c = 0; c < front.own; ++c) {
      const int point = out.order[index(front.rows[index(c)])];
      for (const Stiffness::Entry& entry : K.row(point)) {
        const int other = place[index(entry.column)];
        if (other < front.rows[index(c)] || !(entry.column == point || used[index(entry.slot)])) continue;
        front.entries.push_back({entry.slot, row_of[index(other)], c, entry.column > point});
      }
    }
  }
}

/// Cuts the tree where its branches are small enough to share among threads.
void branch(Elimination& out) {
  const std::vector<Front>& fronts = out.fronts;
  std::vector<double> work(fronts.size());
  std::vector<int> first(fronts.size());  // of the subtree: CHOLMOD numbers it in one run
  double all = 0;
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    first[f] = fronts[f].children.empty() ? static_cast<int>(f) : first[index(fronts[f].children.front())];
    double own = 0;
    for (int k = 0; k < fronts[f].own; ++k) own += static_cast<double>(fronts[f].size() - k) * (fronts[f].size() - k);
    all += own;
    work[f] += own;
    if (fronts[f].parent >= 0) work[index(fronts[f].parent)] += work[f];
  }
  for (int f = static_cast<int>(fronts.size()) - 1; f >= 0;) {
    if (work[index(f)] <= largest_branch * all) {
      out.branches.emplace_back(first[index(f)], f);
      f = first[index(f)] - 1;
    } else {
      out.trunk.push_back(f--);
    }
  }
  std::reverse(out.trunk.begin(), out.trunk.end());
  std::stable_sort(out.branches.begin(), out.branches.end(),
                   [&](const auto& a, const auto& b) { return work[index(a.second)] > work[index(b.second)]; });
}

}  // namespace

Elimination eliminate(const Stiffness& K, const std::vector<char>& used) {
  Elimination result;
  {
    const Analysis analysis(K, used);
    result.order.assign(analysis.order().begin(), analysis.order().end());
    for (int f = 0; f < analysis.fronts(); ++f) {
      const auto rows = analysis.rows(f);
      Front front;
      front.rows.assign(rows.begin(), rows.end());
      front.own = analysis.own(f);
      result.fronts.push_back(std::move(front));
    }
  }
  link(result.fronts, K.points());
  place_entries(K, used, result);
  branch(result);
  return result;
}

}  // namespace wale
