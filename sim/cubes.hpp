/// Space cut into equal cubes, to find what is near what.
#pragma once

#include <Eigen/Core>

#include "sim/fabric.hpp"

namespace wale {

using CubeIndex = Eigen::Array3i;

/// Cubes side by side along the axes that cover points; each cube and each coordinate in units of a cube's width has
/// its origin at the lowest corner.
class Cubes {
 public:
  /// Wider than `width`, m, where there would be more than `most` of them: a few far-flung points must not cost memory.
  Cubes(const Points& covered, double width, double most) : low_(covered.rowwise().minCoeff()), width_(width) {
    const Vec3 span = covered.rowwise().maxCoeff() - low_;
    while ((span / width_ + Vec3::Ones()).prod() > most) width_ *= 1.26;
    count_ = (span / width_).cast<int>().array() + 1;
  }

  double width() const { return width_; }
  /// How many there are along each axis.
  const CubeIndex& count() const { return count_; }
  std::size_t all() const { return flat_in(count_, count_ - 1) + 1; }
  /// A place in units of a cube's width.
  Vec3 in_widths(const Vec3& place) const { return (place - low_) / width_; }
  /// The cube that a place lies in.
  CubeIndex of(const Vec3& place) const { return in_widths(place).cast<int>(); }
  /// The number of a cube, below all().
  std::size_t flat(const CubeIndex& cube) const { return flat_in(count_, cube); }

  /// Visits the cube that a place lies in, and those that touch it.
  template <class Visit>
  void each_around(const Vec3& place, const Visit& visit) const {
    const CubeIndex centre = of(place), low = (centre - 1).max(0), high = (centre + 1).min(count_ - 1);
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) visit(flat({x, y, z}));
  }

  /// The number of a cell among `count` of them along each axis.
  static std::size_t flat_in(const CubeIndex& count, const CubeIndex& cell) {
    const auto at = cell.cast<std::size_t>(), of = count.cast<std::size_t>();
    return at.x() + of.x() * (at.y() + of.y() * at.z());
  }

 private:
  Vec3 low_;
  double width_ = 0;
  CubeIndex count_;
};

}  // namespace wale
