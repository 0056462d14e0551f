/// Finds the points near a place.
#pragma once

#include <vector>

#include "sim/cubes.hpp"

namespace wale {

/// Points sorted into cubes, for finding all that lie within one cube's width of each other.
class Grid {
 public:
  Grid(const Points& at, double width) : cubes_(at, width, 8.0 * static_cast<double>(at.cols()) + 64) {
    start_.assign(cubes_.all() + 1, 0);
    order_.resize(static_cast<std::size_t>(at.cols()));
    for (int i = 0; i < at.cols(); ++i) ++start_[cube(at.col(i)) + 1];
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (int i = 0; i < at.cols(); ++i) order_[static_cast<std::size_t>(next[cube(at.col(i))]++)] = i;
  }

  template <class Visit>
  void near(const Vec3& where, const Visit& visit) const {
    cubes_.each_around(where, [&](std::size_t cube) {
      for (int k = start_[cube]; k < start_[cube + 1]; ++k) visit(order_[static_cast<std::size_t>(k)]);
    });
  }

 private:
  std::size_t cube(const Vec3& at) const { return cubes_.flat(cubes_.of(at)); }

  Cubes cubes_;
  std::vector<int> start_, order_;
};

}  // namespace wale
