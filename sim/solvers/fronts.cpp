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
        waiting_(index(supernodes.count())),
        children_(index(supernodes.count())) {
    const std::vector<int>& order = supernodes.order();
    for (std::size_t k = 0; k < order.size(); ++k) place_[index(order[k])] = static_cast<int>(k);
    Eigen::Index largest = 0;
    for (int s = 0; s < supernodes.count(); ++s) {
      largest = std::max(largest, Eigen::Index{9} * supernodes.width(s) * supernodes.height(s));
      if (supernodes.parent(s) >= 0) children_[index(supernodes.parent(s))].push_back(s);
    }
    columns_.resize(largest);
  }

  bool factor(Panels& out, Eigen::MatrixXd& border) {
    for (int s = 0; s < supernodes_.count(); ++s) {
      if (!eliminate(s, out)) return false;
      if (supernodes_.parent(s) < 0 && waiting_[index(s)].size() > 0) give_to_border(s, border);
    }
    return true;
  }

 private:
  using Matrix = Eigen::MatrixXd;
  using Columns = Eigen::Map<Matrix>;

  bool eliminate(int s, Panels& out) {
    const int width = supernodes_.width(s), height = supernodes_.height(s);
    Columns columns(columns_.data(), 3 * height, 3 * width);
    columns.setZero();
    for (int r = 0; r < height; ++r) row_[index(supernodes_.rows(s)[r])] = r;
    for (int c = 0; c < width; ++c) add_own(supernodes_.first(s) + c, c, columns);
    Matrix& rest = waiting_[index(s)];
    rest.resize(3 * (height - width), 3 * (height - width));
    const std::vector<int>& children = children_[index(s)];
    if (!children.empty()) rest.setZero();
    for (const int child : children) take(child, columns, rest);
    auto top = columns.topRows(3 * width), below = columns.bottomRows(3 * (height - width));
    if (lapack::dpotrf(top) != 0) return false;
    lapack::dtrsm(top, below);
    lapack::dsyrk(below, children.empty() ? 0 : 1, rest);
    top.triangularView<Eigen::StrictlyUpper>().setZero();
    out.keep(s, columns);
    return true;
  }

  /// Column c of a front, of the point at a place: the blocks of K.
  void add_own(int place, int c, Columns& columns) const {
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

  /// What a child left goes to the columns of the front and to its rest.
  void take(int child, Columns& columns, Matrix& rest) {
    const int width = static_cast<int>(columns.cols());
    add_left(child, [&](int column) {
      return column < width ? columns.col(column).data() : rest.col(column - width).data() - width;
    });
  }

  void give_to_border(int root, Matrix& border) {
    const int own = supernodes_.own(), width = supernodes_.width(root);
    for (int r = width; r < supernodes_.height(root); ++r) {
      const int place = supernodes_.rows(root)[r];
      row_[index(place)] = place - own;
    }
    add_left(root, [&](int column) { return border.col(column).data(); });
  }

  /// Adds what waits, by coordinates of the rows that row_ gives now, and frees it.
  template <class ColumnAt>
  void add_left(int supernode, const ColumnAt& column_at) {
    Matrix& left = waiting_[index(supernode)];
    const int points = static_cast<int>(left.cols()) / 3;
    const int* places = supernodes_.rows(supernode) + supernodes_.width(supernode);
    for (int k = 0; k < points; ++k)
      for (int axis = 0; axis < 3; ++axis) {
        const double* from = left.col(3 * k + axis).data();
        double* to = column_at(3 * row_[index(places[k])] + axis);
        for (int r = axis; r < 3; ++r) to[3 * row_[index(places[k])] + r] += from[3 * k + r];
        for (int m = k + 1; m < points; ++m) {
          double* at = to + 3 * row_[index(places[m])];
          for (int r = 0; r < 3; ++r) at[r] += from[3 * m + r];
        }
      }
    left.resize(0, 0);
  }

  const Stiffness& K_;
  double shift_;
  const UsedBlocks& used_;
  const Supernodes& supernodes_;
  std::vector<int> place_;       // by point; -1: of another part
  std::vector<int> row_;         // by place: which row it is of the front at hand, in points
  std::vector<Matrix> waiting_;  // by supernode: the lower triangle of what it leaves, until its parent takes it
  std::vector<std::vector<int>> children_;
  Eigen::VectorXd columns_;  // of the front at hand
};

}  // namespace

bool factor_by_fronts(const Stiffness& K, double shift, const UsedBlocks& used, const Supernodes& supernodes,
                      Panels& factor, Eigen::MatrixXd& border) {
  return Fronts(K, shift, used, supernodes).factor(factor, border);
}

}  // namespace wale
