#include <algorithm>
#include <cmath>
#include <numeric>

#include "compiler/passes.hpp"
#include "compiler/passes/arc_length.hpp"
#include "compiler/passes/interpolate.hpp"

namespace wale::passes {
namespace {

/// The share of its drawn length that each piece keeps when it is tightened; pieces that belong to no stitch keep what
/// the stitches keep on average.
std::vector<double> shrinkage(const YarnCurve& yarn, const ArcLength& arc) {
  double drawn = 0, wanted = 0;
  for (std::size_t i = 0; i < yarn.pieces.size(); ++i)
    if (yarn.pieces[i].stitch_length > 0) {
      drawn += arc.length_of(i);
      wanted += yarn.pieces[i].stitch_length;
    }
  const double average = drawn > 0 ? wanted / drawn : 1;
  std::vector<double> shares;
  for (std::size_t i = 0; i < yarn.pieces.size(); ++i)
    shares.push_back(yarn.pieces[i].stitch_length > 0 ? yarn.pieces[i].stitch_length / arc.length_of(i)
                                                      : average * yarn.pieces[i].shrink);
  return shares;
}

/// The yarn of a cast-on or bind-off spiral. A chain that has been worked and has set keeps its curl by itself; drawn
/// with its full bending rigidity it would, without friction, straighten and drag the stitches along. So it is pliant.
Material at_edge(Material yarn) {
  constexpr double pliancy = 0.05;
  yarn.name += " edge";
  yarn.bending_rigidity *= pliancy;
  return yarn;
}

/// On average, without those that wait for courses and are drawn long.
double stitch_length_drawn(const YarnCurve& yarn, const ArcLength& arc) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < yarn.pieces.size(); ++i)
    if (yarn.pieces[i].stitch >= 0) lengths.push_back(arc.length_of(i));
  if (lengths.empty()) return arc.total();
  std::vector<double> sorted = lengths;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  std::erase_if(lengths, [longest = 2 * *middle](double length) { return length > longest; });
  return std::accumulate(lengths.begin(), lengths.end(), 0.0) / static_cast<double>(lengths.size());
}

/// Through the ends of `count` pieces of equal length, which go on after the period if there is one.
Points control_points(const ArcLength& arc, int count, const std::optional<PeriodicCell>& cell) {
  const double length = arc.total() / count;
  Points through(3, count + 1);
#pragma omp parallel for schedule(static)
  for (int k = 0; k <= count; ++k) through.col(k) = arc.at(k * length).y;
  if (cell) return interpolate_periodic(through.leftCols(count), cell->course);
  return interpolate(through, arc.at(0).dy.normalized() * length, arc.at(arc.total()).dy.normalized() * length);
}

void fit_yarn(const YarnCurve& curve, int segments_per_stitch, Fabric& fabric) {
  const ArcLength arc(curve);
  const int count =
      std::max(4, static_cast<int>(std::lround(arc.total() / stitch_length_drawn(curve, arc) * segments_per_stitch)));
  const double length = arc.total() / count;
  const std::vector<double> shares = shrinkage(curve, arc);

  const int first_point = static_cast<int>(fabric.points.cols());
  Yarn yarn{first_point, fabric.segment_count(), count};
  fabric.points.conservativeResize(3, first_point + count + 3);
  fabric.points.rightCols(count + 3) = control_points(arc, count, fabric.cell);

  for (int k = 0; k < count; ++k) {
    const std::size_t piece = arc.piece_at((k + 0.5) * length);
    fabric.segments.push_back({static_cast<int>(fabric.yarns.size()), curve.pieces[piece].material,
                               curve.pieces[piece].stitch, length, length * shares[piece]});
  }
  fabric.yarns.push_back(yarn);
}

/// A carrier that never knits must not pass for the thinnest or the thickest yarn of the fabric.
void drop_unused_materials(Fabric& fabric) {
  std::vector<int> kept(fabric.materials.size(), -1);
  for (const Segment& segment : fabric.segments) kept[static_cast<std::size_t>(segment.material)] = 0;
  std::vector<Material> materials;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] < 0) continue;
    kept[i] = static_cast<int>(materials.size());
    materials.push_back(fabric.materials[i]);
  }
  for (Segment& segment : fabric.segments) segment.material = kept[static_cast<std::size_t>(segment.material)];
  fabric.materials = std::move(materials);
}

}  // namespace

Fabric fit(const Curves& curves, const std::vector<Material>& yarns, int segments_per_stitch) {
  Fabric fabric;
  fabric.cell = curves.cell;
  fabric.points.resize(3, 0);
  fabric.materials = yarns;
  for (const Material& yarn : yarns) fabric.materials.push_back(at_edge(yarn));
  for (const YarnCurve& curve : curves.yarns) fit_yarn(curve, segments_per_stitch, fabric);
  drop_unused_materials(fabric);
  return fabric;
}

}  // namespace wale::passes
