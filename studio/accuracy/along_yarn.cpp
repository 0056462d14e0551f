#include "studio/accuracy/along_yarn.hpp"

#include <algorithm>

#include "compiler/passes/interpolate.hpp"
#include "sim/image.hpp"
#include "sim/spline.hpp"

namespace wale {

AlongYarn::AlongYarn(const Fabric& fabric, const Yarn& yarn) : first_point_(yarn.first_point), ends_{0} {
  for (int i = 0; i < yarn.segments; ++i)
    ends_.push_back(ends_.back() + fabric.segment(yarn.first_segment + i).knitted);
  for (double& end : ends_) end /= ends_.back();
}

AlongYarn::Point AlongYarn::at(const Points& q, double share) const {
  const auto after = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, share);
  const double begin = *(after - 1), length = *after - begin;
  const int first = first_point_ + static_cast<int>(after - ends_.begin()) - 1;
  const Basis at = basis((share - begin) / length);
  return {combine(q, first, at.value), combine(q, first, at.first) / length};
}

namespace {

Points lay(const AlongYarn& from, const Points& q, const AlongYarn& to, const Fabric& fabric) {
  const std::vector<double>& ends = to.ends();
  const auto count = static_cast<Eigen::Index>(ends.size());
  Points through(3, count);
  for (Eigen::Index i = 0; i < count; ++i) through.col(i) = from.at(q, ends[static_cast<std::size_t>(i)]).y;
  if (fabric.cell) return interpolate_periodic(through.leftCols(count - 1), q.col(q.cols() - 2));
  const double first = ends[1], last = 1 - ends[ends.size() - 2];
  return interpolate(through, from.at(q, 0).dy * first, from.at(q, 1).dy * last);
}

Points resampled_as_it_lies(const Fabric& from, const Points& q, const Fabric& to) {
  const Eigen::Index periods = to.cell ? 2 : 0;
  Points laid(3, to.points.cols() + periods);
  for (std::size_t i = 0; i < to.yarns.size(); ++i) {
    const Yarn& yarn = to.yarns[i];
    laid.middleCols(yarn.first_point, yarn.points()) = lay(AlongYarn(from, from.yarns[i]), q, AlongYarn(to, yarn), to);
  }
  laid.rightCols(periods) = q.rightCols(periods);
  return laid;
}

/// Around an axis a yarn goes on by a turn, rolled out by a shift.
Points resampled_flat(const Fabric& from, const Points& q, const Fabric& to) {
  const Cylinder on = cylinder(*from.cell, q.rightCols<2>());
  Points laid = resampled_as_it_lies(from, rolled_out(*from.cell, q), to);
  for (Eigen::Index k = 0; k + 2 < laid.cols(); ++k) laid.col(k) = rolled_up(laid.col(k), on);
  laid(2, laid.cols() - 1) = on.curvature * curl_unit(*to.cell);
  return laid;
}

}  // namespace

Points resampled(const Fabric& from, const Points& q, const Fabric& to) {
  if (to.cell && to.cell->may_curl()) return resampled_flat(from, q, to);
  return resampled_as_it_lies(from, q, to);
}

}  // namespace wale
