/// Finds the points near a place.
#pragma once

#include <algorithm>
#include <vector>

#include "sim/fabric.hpp"

namespace wale {

/// Points sorted into cubes, for finding all that lie within one cube's width of each other.
class Grid {
 public:
  Grid(const Points& at, double width) : low_(at.rowwise().minCoeff()), width_(width) {
    const Vec3 span = at.rowwise().maxCoeff() - low_;
    // A few far-flung points must not cost memory: widen the cubes until there are not many more of them than points.
    const double most = 8.0 * static_cast<double>(at.cols()) + 64;
    while ((span / width_ + Vec3::Ones()).prod() > most) width_ *= 1.26;
    for (int k = 0; k < 3; ++k) cells_[k] = static_cast<int>(span[k] / width_) + 1;
    start_.assign(static_cast<std::size_t>(cells_.prod()) + 1, 0);
    order_.resize(static_cast<std::size_t>(at.cols()));
    for (int i = 0; i < at.cols(); ++i) ++start_[flat(cell(at.col(i))) + 1];
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (int i = 0; i < at.cols(); ++i) order_[static_cast<std::size_t>(next[flat(cell(at.col(i)))]++)] = i;
  }

  template <class Visit>
  void near(const Vec3& where, const Visit& visit) const {
    const Eigen::Vector3i centre = cell(where);
    for (int z = std::max(centre.z() - 1, 0); z <= std::min(centre.z() + 1, cells_.z() - 1); ++z)
      for (int y = std::max(centre.y() - 1, 0); y <= std::min(centre.y() + 1, cells_.y() - 1); ++y)
        for (int x = std::max(centre.x() - 1, 0); x <= std::min(centre.x() + 1, cells_.x() - 1); ++x) {
          const std::size_t c = flat({x, y, z});
          for (int k = start_[c]; k < start_[c + 1]; ++k) visit(order_[static_cast<std::size_t>(k)]);
        }
  }

 private:
  Eigen::Vector3i cell(const Vec3& at) const { return ((at - low_) / width_).cast<int>(); }
  std::size_t flat(const Eigen::Vector3i& c) const {
    return static_cast<std::size_t>(c.x()) +
           static_cast<std::size_t>(cells_.x()) *
               (static_cast<std::size_t>(c.y()) +
                static_cast<std::size_t>(cells_.y()) * static_cast<std::size_t>(c.z()));
  }

  Vec3 low_;
  double width_;
  Eigen::Vector3i cells_;
  std::vector<int> start_, order_;
};

}  // namespace wale
