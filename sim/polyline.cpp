#include "sim/polyline.hpp"

#include <stdexcept>

#include "sim/spline.hpp"

namespace wale {

Points polyline(const Fabric& fabric, const Points& q, int first, int last, int per_segment) {
  if (first < 0 || last < first || last >= fabric.segment_count() || per_segment < 1 ||
      fabric.segment(first).yarn != fabric.segment(last).yarn)
    throw std::invalid_argument("polyline: not a range of segments of one yarn");
  Points points(3, (last - first + 1) * per_segment + 1);
  for (int k = 0; k < per_segment; ++k) {
    const Basis at = basis(static_cast<double>(k) / per_segment);
    for (int i = first; i <= last; ++i)
      points.col((i - first) * per_segment + k) = combine(q, fabric.first_point(i), at.value);
  }
  points.rightCols<1>() = combine(q, fabric.first_point(last), basis(1).value);
  return points;
}

}  // namespace wale
