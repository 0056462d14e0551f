#include "sim/solvers/fronts.hpp"

#include <algorithm>

#include "sim/lapack.hpp"

namespace wale {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

class Fronts {
 public:
  Fronts(const Stiffness& K, double shift, const UsedBlocks& used, const Supernodes& supernodes)
      : K_(K),
        shift_(shift),
        used_(used),
        supernodes_(supernodes),
        place_(index(K.points()), -1),
        row_(supernodes.order().size()),
        children_(index(supernodes.count())) {
    const std::vector<int>& order = supernodes.order();
    for (std::size_t k = 0; k < order.size(); ++k) place_[index(order[k])] = static_cast<int>(k);
    for (int s = 0; s < supernodes.count(); ++s)
      if (supernodes.parent(s) >= 0) ++children_[index(supernodes.parent(s))];
    make_room();
  }

  bool factor(Panels& out, Eigen::MatrixXd& border) {
    for (int s = 0; s < supernodes_.count(); ++s)
      if (!eliminate(s, out, border)) return false;
    return true;
  }

 private:
  using Matrix = Eigen::Map<Eigen::MatrixXd>;

  /// Coordinates that a supernode leaves.
  Eigen::Index left_by(int s) const { return Eigen::Index{3} * (supernodes_.height(s) - supernodes_.width(s)); }
  static Eigen::Index packed(Eigen::Index size) { return size * (size + 1) / 2; }

  /// What waits is a stack, since supernodes come branch by branch.
  void make_room() {
    Eigen::Index columns = 0, rest = 0, waiting = 0, most_waiting = 0;
    std::vector<int> stack;
    for (int s = 0; s < supernodes_.count(); ++s) {
      columns = std::max(columns, Eigen::Index{9} * supernodes_.width(s) * supernodes_.height(s));
      rest = std::max(rest, left_by(s) * left_by(s));
      for (int child = 0; child < children_[index(s)]; ++child, stack.pop_back())
        waiting -= packed(left_by(stack.back()));
      if (supernodes_.parent(s) < 0) continue;
      stack.push_back(s);
      waiting += packed(left_by(s));
      most_waiting = std::max(most_waiting, waiting);
    }
    columns_ = std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(columns));
    rest_ = std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(rest));
    values_ = std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(most_waiting));
  }

  bool eliminate(int s, Panels& out, Eigen::MatrixXd& border) {
    const Eigen::Index width = 3 * supernodes_.width(s), left = left_by(s);
    Matrix columns(columns_.get(), width + left, width), rest(rest_.get(), left, left);
    columns.setZero();
    for (int r = 0; r < supernodes_.height(s); ++r) row_[index(supernodes_.rows(s)[r])] = r;
    for (int c = 0; c < supernodes_.width(s); ++c) add_own(supernodes_.first(s) + c, c, columns);
    const int children = children_[index(s)];
    if (children > 0) rest.setZero();
    for (int child = 0; child < children; ++child) take(columns, rest);
    auto top = columns.topRows(width), below = columns.bottomRows(left);
    if (lapack::dpotrf(top) != 0) return false;
    if (left > 0) {
      lapack::dtrsm(top, below);
      lapack::dsyrk(below, children > 0 ? 1 : 0, rest);
    }
    top.triangularView<Eigen::StrictlyUpper>().setZero();
    out.keep(s, columns);
    if (supernodes_.parent(s) < 0)
      give_to_border(s, rest, border);
    else
      wait(s, rest);
    return true;
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

  /// Packs the lower triangle of what s leaves.
  void wait(int s, const Matrix& rest) {
    waiting_.push_back(s);
    for (Eigen::Index j = 0; j < rest.cols(); ++j) {
      const Eigen::Index length = rest.rows() - j;
      std::copy_n(rest.col(j).data() + j, length, values_.get() + filled_);
      filled_ += length;
    }
  }

  /// What waits last goes to the columns of the front and to its rest.
  void take(Matrix& columns, Matrix& rest) {
    const int child = waiting_.back();
    waiting_.pop_back();
    filled_ -= packed(left_by(child));
    const int* places = supernodes_.rows(child) + supernodes_.width(child);
    const double* from = values_.get() + filled_;
    const auto width = static_cast<int>(columns.cols());
    const int points = static_cast<int>(left_by(child)) / 3;
    for (int k = 0; k < points; ++k) {
      const int first = 3 * row_[index(places[k])];
      for (int axis = 0; axis < 3; ++axis) {
        const int column = first + axis;
        double* to = column < width ? columns.col(column).data() : rest.col(column - width).data() - width;
        for (int r = axis; r < 3; ++r) to[first + r] += *from++;
        for (int m = k + 1; m < points; ++m, from += 3) {
          double* at = to + 3 * row_[index(places[m])];
          for (int r = 0; r < 3; ++r) at[r] += from[r];
        }
      }
    }
  }

  void give_to_border(int root, const Matrix& rest, Eigen::MatrixXd& border) const {
    const int* places = supernodes_.rows(root) + supernodes_.width(root);
    const auto at = [&](Eigen::Index i) { return 3 * (places[i / 3] - supernodes_.own()) + i % 3; };
    for (Eigen::Index j = 0; j < rest.cols(); ++j)
      for (Eigen::Index i = j; i < rest.rows(); ++i) border(at(i), at(j)) += rest(i, j);
  }

  const Stiffness& K_;
  double shift_;
  const UsedBlocks& used_;
  const Supernodes& supernodes_;
  std::vector<int> place_;                    // by point; -1: of another part
  std::vector<int> row_;                      // by place: which row it is of the front at hand, in points
  std::vector<int> children_;                 // how many, by supernode
  std::vector<int> waiting_;                  // supernodes whose parents are still to come
  std::unique_ptr<double[]> columns_, rest_;  // of the front at hand
  std::unique_ptr<double[]> values_;          // the lower triangles of what waits
  Eigen::Index filled_ = 0;                   // of values_
};

}  // namespace

bool factor_by_fronts(const Stiffness& K, double shift, const UsedBlocks& used, const Supernodes& supernodes,
                      Panels& factor, Eigen::MatrixXd& border) {
  return Fronts(K, shift, used, supernodes).factor(factor, border);
}

}  // namespace wale
