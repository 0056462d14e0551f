#include "sim/results/shown_fabric.hpp"

#include "sim/tile.hpp"

namespace wale {
namespace {

constexpr int fewest = 6;  // stitches each way

/// Of so many stitches each.
int repeats(int stitches) { return fewest < stitches ? 1 : (fewest + stitches - 1) / stitches; }

}  // namespace

Fabric shown_fabric(const Fabric& fabric, const Gauge& gauge, const Points& q) {
  if (fabric.cell) return tile(fabric, q, repeats(gauge.wales), repeats(gauge.courses));
  Fabric there = fabric;
  there.points = q;
  return there;
}

Points seen_along_axis(Curls curls, const Points& shown) {
  Points seen(3, shown.cols());
  if (curls == Curls::about_courses)
    seen << shown.row(2), shown.row(1), -shown.row(0);
  else
    seen << shown.row(0), shown.row(2), -shown.row(1);
  return seen;
}

}  // namespace wale
