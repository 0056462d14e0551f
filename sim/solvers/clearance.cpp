#include "sim/solvers/clearance.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/image.hpp"
#include "sim/spline.hpp"

namespace wale {
namespace {

constexpr double near = 0.5;  // of the diameter
constexpr int chords = 4;

using Chords = std::array<Vec3, chords + 1>;

Chords chords_of(const Fabric& fabric, const Points& q, int segment) {
  static const auto bases = [] {
    std::array<Basis, chords + 1> at;
    for (int k = 0; k <= chords; ++k) at[static_cast<std::size_t>(k)] = basis(static_cast<double>(k) / chords);
    return at;
  }();
  Chords points;
  for (std::size_t k = 0; k <= chords; ++k) points[k] = combine(q, fabric.first_point(segment), bases[k].value);
  return points;
}

void displace(const Fabric& fabric, const Points& q, const Eigen::Vector2i& steps, Chords& points) {
  if (!fabric.cell->may_curl()) {
    for (Vec3& point : points) point += q.rightCols<2>() * steps.cast<double>();
    return;
  }
  const Image image(*fabric.cell, q.rightCols<2>(), steps);
  for (Vec3& point : points) point = image(point);
}

double along(const Vec3& from, const Vec3& chord, const Vec3& point) {
  const double squared = chord.squaredNorm();
  return squared > 0 ? std::clamp(chord.dot(point - from) / squared, 0.0, 1.0) : 0;
}

/// Between the straight lines from a by u and from b by v (Ericson 2005, Real-Time Collision Detection, 5.1.9).
double chord_distance(const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v) {
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), determinant = uu * vv - uv * uv;
  const Vec3 apart = a - b;
  double s =
      determinant > 1e-12 * uu * vv ? std::clamp((uv * v.dot(apart) - vv * u.dot(apart)) / determinant, 0.0, 1.0) : 0;
  const double t = along(b, v, a + s * u);
  s = along(a, u, b + t * v);
  return (apart + s * u - t * v).norm();
}

/// Whether they share a point, or have so little yarn between them that none can pass there.
bool follow_each_other(const Fabric& fabric, const Gap& gap) {
  if (!gap.image.isZero() || fabric.segment(gap.a).yarn != fabric.segment(gap.b).yarn) return false;
  const int first = std::min(gap.a, gap.b), last = std::max(gap.a, gap.b);
  double between = 0;  // m
  for (int i = first + 1; i < last && between < gap.diameter; ++i) between += fabric.segment(i).knitted;
  return between < gap.diameter;
}

}  // namespace

double thinnest_diameter(const Fabric& fabric) {
  const auto thinner = [](const Material& a, const Material& b) { return a.diameter < b.diameter; };
  return std::min_element(fabric.materials.begin(), fabric.materials.end(), thinner)->diameter;
}

double axis_distance(const Fabric& fabric, const Points& q, const Gap& gap) {
  if (follow_each_other(fabric, gap)) return gap.distance;
  const Chords a = chords_of(fabric, q, gap.a);
  Chords b = chords_of(fabric, q, gap.b);
  if (!gap.image.isZero()) displace(fabric, q, gap.image, b);
  double least = gap.distance;
  for (std::size_t i = 0; i < chords; ++i)
    for (std::size_t j = 0; j < chords; ++j)
      least = std::min(least, chord_distance(a[i], a[i + 1] - a[i], b[j], b[j + 1] - b[j]));
  return least;
}

double clearance(const Fabric& fabric, const Points& q, const std::vector<Gap>& gaps) {
  double least = near;
  for (const Gap& gap : gaps)
    if (gap.distance < near * gap.diameter) least = std::min(least, axis_distance(fabric, q, gap) / gap.diameter);
  return least;
}

int about_to_pass(const Fabric& fabric, const Points& before, const Points& after, const std::vector<Gap>& gaps) {
  for (const Gap& gap : gaps) {
    const bool may_pass = fabric.material_of(gap.a).law == ContactLaw::quadratic ||
                          fabric.material_of(gap.b).law == ContactLaw::quadratic;
    if (may_pass || !(gap.distance < near * gap.diameter)) continue;
    const double apart = axis_distance(fabric, after, gap);
    if (apart < least_clearance * gap.diameter && apart < axis_distance(fabric, before, gap)) return gap.a;
  }
  return -1;
}

}  // namespace wale
