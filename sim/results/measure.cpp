#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "sim/image.hpp"
#include "sim/polyline.hpp"
#include "sim/results/curves.hpp"
#include "sim/spline.hpp"

namespace wale {
namespace {

/// The mean of the yarn axis over some segments, each counted alike.
Vec3 mean_position(const Fabric& fabric, const Points& q, const std::vector<int>& segments) {
  Vec3 sum = Vec3::Zero();
  for (const int i : segments)
    for (const GaussNode& node : gauss(2)) sum += node.weight * combine(q, fabric.first_point(i), basis(node.s).value);
  return sum / static_cast<double>(segments.size());
}

/// The unit vector from one grip to the other; zero if there are no two grips apart from each other.
Vec3 direction(const Fabric& fabric, const Points& q, const std::array<std::vector<int>, 2>& grips) {
  if (grips[0].empty() || grips[1].empty()) return Vec3::Zero();
  const Vec3 apart = mean_position(fabric, q, grips[1]) - mean_position(fabric, q, grips[0]);
  return apart.norm() > 0 ? Vec3(apart.normalized()) : Vec3(Vec3::Zero());
}

/// One point a stitch, in the order in which stitches are first met along the yarns; and its yarn.
struct Stitches {
  std::vector<Vec3> centres;
  std::vector<int> yarns;
};

Stitches stitches(const Fabric& fabric, const Points& q) {
  std::map<int, std::size_t> known;
  std::vector<std::vector<int>> segments;
  for (int i = 0; i < fabric.segment_count(); ++i) {
    const int stitch = fabric.segment(i).stitch;
    if (stitch < 0) continue;
    const auto [at, is_new] = known.try_emplace(stitch, segments.size());
    if (is_new) segments.emplace_back();
    segments[at->second].push_back(i);
  }
  Stitches found;
  for (const std::vector<int>& of_stitch : segments) {
    found.centres.push_back(mean_position(fabric, q, of_stitch));
    found.yarns.push_back(fabric.segment(of_stitch.front()).yarn);
  }
  return found;
}

/// The spacing of `count` evenly filled rows from the spread of the stitches along an axis; see measure().
double grid_spacing(const Stitches& of, const Vec3& axis, double count) {
  if (count < 2 || of.centres.empty() || axis.isZero()) return 0;
  double mean = 0, variance = 0;
  const double n = static_cast<double>(of.centres.size());
  for (const Vec3& centre : of.centres) mean += axis.dot(centre) / n;
  for (const Vec3& centre : of.centres) variance += std::pow(axis.dot(centre) - mean, 2) / n;
  return std::sqrt(12 * variance / (count * count - 1));
}

/// The mean distance across the axis of stitches that follow each other on a yarn.
double step_around(const Stitches& of, const Vec3& axis) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 1; i < of.centres.size(); ++i) {
    if (of.yarns[i] != of.yarns[i - 1]) continue;
    const Vec3 step = of.centres[i] - of.centres[i - 1];
    sum += (step - axis.dot(step) * axis).norm();
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

double thickness(const Fabric& fabric, const Points& q, const Vec3& across) {
  std::vector<double> heights;
  for (const Yarn& yarn : fabric.yarns) {
    if (yarn.segments == 0) continue;
    const Points axis = polyline(fabric, q, yarn.first_segment, yarn.first_segment + yarn.segments - 1, 4);
    for (Eigen::Index i = 0; i < axis.cols(); ++i) heights.push_back(across.dot(axis.col(i)));
  }
  if (heights.empty()) return 0;
  const auto percentile = [&](double share) {
    const auto at = heights.begin() + std::lround(share * static_cast<double>(heights.size() - 1));
    std::nth_element(heights.begin(), at, heights.end());
    return *at;
  };
  double diameter = 0;
  for (const Material& material : fabric.materials) diameter = std::max(diameter, material.diameter);
  return percentile(0.95) - percentile(0.05) + diameter;
}

Sizes measure_repeat(const Fabric& fabric, const Gauge& gauge, const Points& q) {
  Sizes sizes;
  sizes.width = q(0, q.cols() - 2);
  sizes.length = q(1, q.cols() - 1);
  sizes.wale_spacing = sizes.width / gauge.wales;
  sizes.course_spacing = sizes.length / gauge.courses;
  const bool curls = fabric.cell->may_curl();
  sizes.thickness = thickness(fabric, curls ? rolled_out(*fabric.cell, q) : q, Vec3::UnitZ());
  return sizes;
}

}  // namespace

Sizes measure(const Fabric& fabric, const Gauge& gauge, const Points& q) {
  if (fabric.cell) return measure_repeat(fabric, gauge, q);
  const Vec3 along = direction(fabric, q, gauge.wale_ends), across = direction(fabric, q, gauge.course_ends);
  const Vec3 normal = across.cross(along);
  const Stitches of = stitches(fabric, q);
  Sizes sizes;
  sizes.course_spacing = grid_spacing(of, along, gauge.courses);
  if (across.isZero() && !along.isZero())
    sizes.wale_spacing = step_around(of, along);
  else
    sizes.wale_spacing = grid_spacing(of, across, gauge.wales);
  sizes.length = gauge.courses * sizes.course_spacing;
  sizes.width = gauge.wales * sizes.wale_spacing;
  sizes.thickness = thickness(fabric, q, normal.norm() > 0.1 ? Vec3(normal.normalized()) : Vec3(Vec3::UnitZ()));
  return sizes;
}

}  // namespace wale
