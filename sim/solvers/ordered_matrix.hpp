/// A Stiffness by compressed scalar columns, its points in an order that keeps the Cholesky factor sparse.
#pragma once

#include <cholmod.h>

#include <vector>

#include "sim/stiffness.hpp"

namespace wale {

/// The lower triangle, as CHOLMOD reads it; blocks on the diagonal are whole. Keeps its pattern as long as no block is
/// other than zero that was zero: most listed pairs of yarn do not touch, and to leave them out halves the work.
class OrderedMatrix {
 public:
  /// Takes the values of K. True if the pattern changed.
  bool update(const Stiffness& K);

  /// The points, first eliminated first.
  const std::vector<int>& order() const { return order_; }
  /// Good until the next update().
  cholmod_sparse view();

 private:
  struct Block {
    int row = 0;  // a place in the order
    int slot = 0;
    bool transposed = false;
  };
  bool find_used(const Stiffness& K);
  bool is_used(int point, const Stiffness::Entry& entry) const;
  void find_order(const Stiffness& K);
  void lay_out(const Stiffness& K);
  void copy_values(const Stiffness& K);

  std::vector<char> used_;     // by slot: whether the pattern has a block there
  std::vector<int> order_;     // the point at each place
  std::vector<int> first_;     // by place: where its blocks start; one more at the end
  std::vector<Block> blocks_;  // of the lower triangle: column by column, rows ascending
  std::vector<int> starts_;    // by scalar column: where it starts in rows_ and values_; one more at the end
  std::vector<int> rows_;
  std::vector<double> values_;
};

}  // namespace wale
