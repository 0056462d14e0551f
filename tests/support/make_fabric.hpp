/// Yarns laid by hand, for tests that want no compiler.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/effect.hpp"
#include "sim/fabric.hpp"

namespace wale {

/// Appends a yarn with these control points; every segment's rest length is `rest_length` and is not to be tightened.
inline void add_yarn(Fabric& fabric, const Points& points, double rest_length, int material = 0) {
  Yarn yarn{static_cast<int>(fabric.points.cols()), fabric.segment_count(), static_cast<int>(points.cols()) - 3};
  for (int i = 0; i < yarn.segments; ++i)
    fabric.segments.push_back({.yarn = static_cast<std::int32_t>(fabric.yarns.size()),
                               .material = material,
                               .stitch = -1,
                               .length = rest_length,
                               .knitted = rest_length});
  const Eigen::Index before = fabric.points.cols();
  fabric.points.conservativeResize(3, before + points.cols());
  fabric.points.rightCols(points.cols()) = points;
  fabric.yarns.push_back(yarn);
}

/// The control points of a straight yarn from `from` to `to`: a uniform B-spline repeats a linear function.
inline Points straight_points(const Vec3& from, const Vec3& to, int segments) {
  Points points(3, segments + 3);
  for (int k = 0; k < segments + 3; ++k) points.col(k) = from + (k - 1.0) / segments * (to - from);
  return points;
}

/// One straight yarn along +x from the origin, unstretched.
inline Fabric straight_rod(double length, int segments, const Material& material = {}) {
  Fabric fabric;
  fabric.materials = {material};
  add_yarn(fabric, straight_points(Vec3::Zero(), Vec3(length, 0, 0), segments), length / segments);
  return fabric;
}

/// Adds noise of size `by` to every control point; the same for the same seed.
inline void shake(Points& points, double by, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-by, by);
  for (double& x : points.reshaped()) x += noise(random);
}

/// A wavy yarn of one material crosses under a hairpin of another, whose legs touch; everything shaken by `seed`.
inline Fabric crossing_yarns(ContactLaw law, unsigned seed) {
  Fabric fabric;
  fabric.materials = {{.name = "thick", .law = law}, {.name = "thin", .bending_rigidity = 0.8e-8, .law = law}};
  fabric.materials[1].diameter = 0.45e-3;
  fabric.materials[1].core_diameter = 0.15e-3;
  const double l = 0.6e-3;
  Points wave(3, 9), hairpin(3, 11);
  for (int k = 0; k < 9; ++k) wave.col(k) = Vec3((k - 4) * l, 0.3 * l * std::sin(1.1 * k), 0.1 * l * std::cos(2.0 * k));
  for (int k = 0; k < 11; ++k) {
    const double side = std::clamp((k - 5) / 1.5, -1.0, 1.0);
    hairpin.col(k) = Vec3(0.31 * l * side, (3 - std::abs(k - 5)) * l, 0.62 * l);
  }
  add_yarn(fabric, wave, l);
  add_yarn(fabric, hairpin, 1.05 * l, 1);
  shake(fabric.points, 0.04 * l, seed);
  return fabric;
}

/// `count` yarns along x lie on `count` along y, shaken: enough segments and touching pairs for several threads.
inline Fabric woven_yarns(int count, int segments, unsigned seed) {
  Fabric fabric;
  fabric.materials = {Material{}};
  const double l = 0.6e-3, length = l * segments;
  for (int i = 0; i < count; ++i) {
    const double at = length * (i + 0.5) / count;
    add_yarn(fabric, straight_points({0, at, 0}, {length, at, 0}, segments), l);
    add_yarn(fabric, straight_points({at, 0, 0.45e-3}, {at, length, 0.45e-3}, segments), l);
  }
  shake(fabric.points, 0.1 * l, seed);
  return fabric;
}

/// The fabric as laid, moving at up to `speed` m/s.
inline State shaken_state(const Fabric& fabric, double speed, unsigned seed) {
  State state{.t = 0, .q = fabric.points, .v = Points::Zero(3, fabric.points.cols()), .step = 0};
  shake(state.v, speed, seed);
  return state;
}

}  // namespace wale
