/// A yarn by how much of it lies behind, whatever its segments are: places of one fabric in several resolutions.
#pragma once

#include <vector>

#include "sim/fabric.hpp"

namespace wale {

class AlongYarn {
 public:
  AlongYarn(const Fabric&, const Yarn&);

  struct Point {
    Vec3 y, dy;  ///< m; the derivative by the share
  };
  /// Where `share` of the yarn's knitted length lies behind, 0 to 1. `q`: control points of its fabric.
  Point at(const Points& q, double share) const;
  /// Shares at the ends of the segments, 0 to 1, one more than there are segments.
  const std::vector<double>& ends() const { return ends_; }

 private:
  int first_point_;
  std::vector<double> ends_;
};

/// The state of `to` in which its yarns lie as those of `from` do in `q`: through the same places where its segments
/// end. Both are of one pattern with other numbers of segments; `q` is as State::q.
Points resampled(const Fabric& from, const Points& q, const Fabric& to);

}  // namespace wale
