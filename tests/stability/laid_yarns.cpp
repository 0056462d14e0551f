#include "tests/stability/laid_yarns.hpp"

#include <cmath>
#include <numeric>

#include "sim/polyline.hpp"
#include "tests/support/make_fabric.hpp"

namespace wale::stability {
namespace {

/// Chaikin's corner cutting; the ends stay.
std::vector<Vec3> rounded(std::vector<Vec3> line, int times) {
  for (; times > 0; --times) {
    std::vector<Vec3> cut{line.front()};
    for (std::size_t i = 1; i < line.size(); ++i) {
      cut.push_back(0.75 * line[i - 1] + 0.25 * line[i]);
      cut.push_back(0.25 * line[i - 1] + 0.75 * line[i]);
    }
    cut.push_back(line.back());
    line = std::move(cut);
  }
  return line;
}

double length_of(const std::vector<Vec3>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
  return sum;
}

Vec3 point_at(const std::vector<Vec3>& line, double s) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double piece = (line[i] - line[i - 1]).norm();
    if (s <= piece) return line[i - 1] + s / piece * (line[i] - line[i - 1]);
    s -= piece;
  }
  return line.back();
}

std::vector<int> segments_from(int first, int count) {
  std::vector<int> segments(static_cast<std::size_t>(count));
  std::iota(segments.begin(), segments.end(), first);
  return segments;
}

}  // namespace

Fabric fabric_of(std::vector<Material> materials) {
  Fabric fabric;
  fabric.materials = std::move(materials);
  return fabric;
}

void lay(Fabric& fabric, const std::vector<Vec3>& corners, int material) {
  const std::vector<Vec3> line = rounded(corners, 4);
  const double length = length_of(line);
  const int segments = std::max(1, static_cast<int>(std::lround(length / l)));
  Points points(3, segments + 3);
  for (int k = 0; k <= segments; ++k) points.col(k + 1) = point_at(line, length * k / segments);
  points.col(0) = 2 * points.col(1) - points.col(2);
  points.col(segments + 2) = 2 * points.col(segments + 1) - points.col(segments);
  add_yarn(fabric, points, length / segments, material);
  unstretch(fabric, static_cast<int>(fabric.yarns.size()) - 1);
}

void unstretch(Fabric& fabric, int yarn) {
  const Yarn& of = fabric.yarns[static_cast<std::size_t>(yarn)];
  for (int i = of.first_segment; i < of.first_segment + of.segments; ++i) {
    const Points line = polyline(fabric, fabric.points, i, i, 16);
    Segment& segment = fabric.segments[static_cast<std::size_t>(i)];
    segment.length = segment.knitted = (line.rightCols(16) - line.leftCols(16)).colwise().norm().sum();
  }
}

Fabric crossing(double gap) {
  Fabric fabric = fabric_of();
  const double half = 6 * l;
  add_yarn(fabric, straight_points({-half, 0, 0}, {half, 0, 0}, 12), l);
  add_yarn(fabric, straight_points({0, -half, gap}, {0, half, gap}, 12), l);
  return fabric;
}

Fabric hooked_loops(const Material& first, const Material& second) {
  Fabric fabric = fabric_of({first, second});
  const double w = 0.8e-3, legs = 5e-3, head = 0.6 * d;
  lay(fabric, {{-w, -legs, 0}, {-w, -w, 0}, {-w, head, 0}, {w, head, 0}, {w, -w, 0}, {w, -legs, 0}});
  lay(fabric, {{0, legs, -w}, {0, w, -w}, {0, -head, -w}, {0, -head, w}, {0, w, w}, {0, legs, w}}, 1);
  return fabric;
}

std::vector<int> start_of(const Fabric& fabric, int yarn, int count) {
  return segments_from(fabric.yarns[static_cast<std::size_t>(yarn)].first_segment, count);
}

std::vector<int> end_of(const Fabric& fabric, int yarn, int count) {
  const Yarn& of = fabric.yarns[static_cast<std::size_t>(yarn)];
  return segments_from(of.first_segment + of.segments - count, count);
}

std::vector<int> ends_of(const Fabric& fabric, int yarn, int count) {
  std::vector<int> both = start_of(fabric, yarn, count), end = end_of(fabric, yarn, count);
  both.insert(both.end(), end.begin(), end.end());
  return both;
}

Points round_by(const Vec3& from, const Vec3& by, const Vec3& to) {
  Points way(3, 4);
  way << far_off * from, far_off * (from + by), far_off * (to + by), far_off * to;
  return way;
}

}  // namespace wale::stability
