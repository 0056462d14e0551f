/// Some points of a Stiffness by compressed scalar columns, in a given order.
#pragma once

#include <cholmod.h>

#include <vector>

#include "sim/solvers/used_blocks.hpp"

namespace wale {

/// The lower triangle, as CHOLMOD reads it; blocks on the diagonal are whole.
class OrderedMatrix {
 public:
  /// `order` are the points, first eliminated first; blocks with others, or that are not used, are left out.
  OrderedMatrix(const Stiffness& K, const UsedBlocks& used, std::vector<int> order);

  /// Takes the values of K, which must have the slots that it was made with.
  void take(const Stiffness& K);
  const std::vector<int>& order() const { return order_; }
  /// Good as long as this.
  cholmod_sparse view();

 private:
  struct Block {
    int row = 0;  // a place in the order
    int slot = 0;
    bool transposed = false;
  };

  std::vector<int> order_;      // the point at each place
  std::vector<int> first_{0};   // by place: where its blocks start; one more at the end
  std::vector<Block> blocks_;   // of the lower triangle: column by column, rows ascending
  std::vector<int> starts_{0};  // by scalar column: where it starts in rows_ and values_; one more at the end
  std::vector<int> rows_;
  std::vector<double> values_;
};

}  // namespace wale
