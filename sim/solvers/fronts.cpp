#include "sim/solvers/fronts.hpp"

#include <algorithm>

#include "sim/lapack.hpp"
#include "sim/large_pages.hpp"

namespace wale {
namespace {

constexpr Eigen::Index wide = 96;  // coordinates that a front leaves for its parent, made at a time

std::size_t index(int i) { return static_cast<std::size_t>(i); }

class Fronts {
 public:
  Fronts(const Stiffness& K, double shift, const UsedBlocks& used, const Supernodes& supernodes,
         const FrontSequence& sequence)
      : K_(K),
        shift_(shift),
        used_(used),
        supernodes_(supernodes),
        place_(index(K.points()), -1),
        row_(supernodes.order().size()),
        sequence_(sequence) {
    const std::vector<int>& order = supernodes.order();
    for (std::size_t k = 0; k < order.size(); ++k) place_[index(order[k])] = static_cast<int>(k);
    Eigen::Index rest = 0;
    for (int s = 0; s < supernodes.count(); ++s) rest = std::max(rest, left_by(s) * std::min(left_by(s), wide));
    rest_.resize(static_cast<std::size_t>(rest));
    values_.resize(sequence_.room());
  }

  bool factor(Panels& out, LowerTriangle& border) {
    const std::vector<int>& all = sequence_.supernodes();
    return std::all_of(all.begin(), all.end(), [&](int s) { return eliminate(s, out, border); });
  }

 private:
  using Matrix = Eigen::Map<Eigen::MatrixXd>;

  /// Coordinates that a supernode leaves.
  Eigen::Index left_by(int s) const { return Eigen::Index{3} * (supernodes_.height(s) - supernodes_.width(s)); }

  bool eliminate(int s, Panels& out, LowerTriangle& border) {
    const Eigen::Index width = 3 * supernodes_.width(s);
    Matrix columns(values_.data() + filled_, width + left_by(s), width);
    columns.setZero();
    for (int r = 0; r < supernodes_.height(s); ++r) row_[index(supernodes_.rows(s)[r])] = r;
    for (int c = 0; c < supernodes_.width(s); ++c) add_own(supernodes_.first(s) + c, c, columns);
    call_children(s);
    for (Child& child : arriving_) take(child, 0, columns);
    auto top = columns.topRows(width), below = columns.bottomRows(left_by(s));
    if (lapack::dpotrf(top) != 0) return false;
    if (left_by(s) > 0) lapack::dtrsm(top, below);
    top.triangularView<Eigen::StrictlyUpper>().setZero();
    out.keep(s, columns);
    leave(s, columns, border);
    return true;
  }

  /// What is left of the rows below `columns`.
  void leave(int s, const Matrix& columns, LowerTriangle& border) {
    const Eigen::Index width = columns.cols(), left = left_by(s);
    double *const begin = values_.data() + filled_ + columns.size(), *end = begin;
    for (Eigen::Index first = 0; first < left; first += wide) {
      const Eigen::Index size = std::min(wide, left - first), below = left - first - size;
      Matrix rest(rest_.data(), left - first, size);
      rest.setZero();
      for (Child& child : arriving_) take(child, width + first, rest);
      const auto mine = columns.middleRows(width + first, size);
      lapack::dsyrk(mine, rest.topRows(size));
      if (below > 0) lapack::dgemm(columns.bottomRows(below), mine, rest.bottomRows(below));
      if (supernodes_.parent(s) < 0)
        give_to_border(s, first, rest, border);
      else
        for (Eigen::Index j = 0; j < size; ++j)
          end = std::copy(rest.col(j).data() + j, rest.col(j).data() + rest.rows(), end);
    }
    dismiss_children(begin, end);
    if (supernodes_.parent(s) >= 0) waiting_.push_back(s);
  }

  /// What a supernode left that is in the front at hand now, by packed columns.
  struct Child {
    int supernode = 0;
    int next = 0;                  // column to be taken, in points
    const double* from = nullptr;  // its values
  };

  void call_children(int s) {
    arriving_.clear();
    const double* end = values_.data() + filled_;
    for (int child = 0; child < sequence_.branches(s); ++child) {
      const int supernode = waiting_[waiting_.size() - 1 - index(child)];
      end -= values_left(supernodes_, supernode);
      arriving_.push_back({supernode, 0, end});
    }
  }

  /// What was made above them takes their room.
  void dismiss_children(const double* begin, const double* end) {
    for (const Child& child : arriving_) filled_ -= values_left(supernodes_, child.supernode);
    waiting_.resize(waiting_.size() - arriving_.size());
    filled_ = static_cast<std::size_t>(std::copy(begin, end, values_.data() + filled_) - values_.data());
  }

  /// Column c of a front, of the point at a place: the blocks of K.
  void add_own(int place, int c, Matrix& columns) const {
    const int point = supernodes_.order()[index(place)];
    for (const Stiffness::Entry& entry : K_.row(point)) {
      const int row = place_[index(entry.column)];
      if (row < place || !used_.has(point, entry)) continue;
      auto block = columns.block<3, 3>(3 * row_[index(row)], 3 * c);
      if (entry.column > point)
        block = K_.at(entry.slot).transpose();
      else
        block = K_.at(entry.slot);
    }
    columns.block<3, 3>(3 * c, 3 * c).diagonal().array() += shift_;
  }

  /// Adds a child's columns as far as `columns` reach, which begin at coordinate (first, first) of the front.
  void take(Child& child, Eigen::Index first, Matrix& columns) const {
    const int* places = supernodes_.rows(child.supernode) + supernodes_.width(child.supernode);
    const int points = supernodes_.height(child.supernode) - supernodes_.width(child.supernode);
    for (; child.next < points; ++child.next) {
      const Eigen::Index at = 3 * row_[index(places[child.next])];
      if (at >= first + columns.cols()) return;
      for (int axis = 0; axis < 3; ++axis) {
        double* const to = columns.col(at + axis - first).data() - first;
        for (int r = axis; r < 3; ++r) to[at + r] += *child.from++;
        for (int m = child.next + 1; m < points; ++m, child.from += 3)
          for (int r = 0; r < 3; ++r) to[3 * row_[index(places[m])] + r] += child.from[r];
      }
    }
  }

  void give_to_border(int root, Eigen::Index first, const Matrix& rest, LowerTriangle& border) const {
    const int* places = supernodes_.rows(root) + supernodes_.width(root);
    const auto at = [&](Eigen::Index i) { return 3 * (places[(first + i) / 3] - supernodes_.own()) + (first + i) % 3; };
    for (Eigen::Index j = 0; j < rest.cols(); ++j)
      for (Eigen::Index i = j; i < rest.rows(); ++i) border.column(at(j))[at(i) - at(j)] += rest(i, j);
  }

  const Stiffness& K_;
  double shift_;
  const UsedBlocks& used_;
  const Supernodes& supernodes_;
  std::vector<int> place_;  // by point; -1: of another part
  std::vector<int> row_;    // by place: which row it is of the front at hand, in points
  const FrontSequence& sequence_;
  std::vector<int> waiting_;     // supernodes whose parents are still to come
  std::vector<Child> arriving_;  // of the front at hand, last eliminated first
  LargeArray<double> values_;    // the lower triangles of what waits, and the columns of the front at hand
  LargeArray<double> rest_;      // of what it leaves
  Eigen::Index filled_ = 0;      // of values_
};

}  // namespace

bool factor_by_fronts(const Stiffness& K, double shift, const UsedBlocks& used, const Supernodes& supernodes,
                      const FrontSequence& sequence, Panels& factor, LowerTriangle& border) {
  return Fronts(K, shift, used, supernodes, sequence).factor(factor, border);
}

}  // namespace wale
