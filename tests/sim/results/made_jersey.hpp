/// A jersey-like fabric without the compiler: the loop curve of Ding et al. 2023, Eq. (4), one yarn a course.
#pragma once

#include <cmath>
#include <numbers>

#include "sim/scene.hpp"

namespace wale::testing {

struct MadeJersey {
  Fabric fabric;
  std::vector<Crossing> crossings;
  Gauge gauge;  ///< grips are the outermost loops
  double diameter = 0.524e-3, wale_spacing = 0, course_spacing = 0;
};

/// A loop is w in [-2, 2], its head at w = 0, behind; its legs about w = -1 and 1, in front.
inline Vec3 loop_point(double w, double d) {
  constexpr double pi = std::numbers::pi;
  const double lx = 1.2 * d, ly = 2.6 * d, lz = 0.76 * d;
  return {lx * (w + std::sin(pi * w)), ly * std::cos(pi * w / 2), -lz * std::cos(pi * w)};
}

/// `per_loop` segments a loop; legs of a course come from behind, through the loops below. Control points lie on the
/// curve itself, so the spline is a little tighter than it.
inline MadeJersey made_jersey(int wales, int courses, int per_loop = 16) {
  MadeJersey made;
  const double d = made.diameter;
  made.wale_spacing = 4 * 1.2 * d;
  made.course_spacing = 3.4 * d;
  Fabric& fabric = made.fabric;
  fabric.materials = {Material{}};
  const int segments = wales * per_loop, points = segments + 3;
  fabric.points.resize(3, points * courses);
  for (int course = 0; course < courses; ++course) {
    fabric.yarns.push_back({course * points, course * segments, segments});
    for (int k = 0; k < points; ++k)
      fabric.points.col(course * points + k) =
          loop_point(-2 + 4.0 * (k - 1) / per_loop, d) + Vec3(0, course * made.course_spacing, 0);
    for (int k = 0; k < segments; ++k) {
      Segment segment{course, 0, course * wales + k / per_loop, 0, 0};
      segment.length = segment.knitted = 4.0 * 1.9 * d / per_loop;
      fabric.segments.push_back(segment);
    }
  }
  made.gauge.wales = wales;
  made.gauge.courses = courses;
  for (int i = 0; i < fabric.segment_count(); ++i) {
    const int course = i / segments, wale = i % segments / per_loop;
    if (course == 0) made.gauge.wale_ends[0].push_back(i);
    if (course == courses - 1) made.gauge.wale_ends[1].push_back(i);
    if (wale == 0) made.gauge.course_ends[0].push_back(i);
    if (wale == wales - 1) made.gauge.course_ends[1].push_back(i);
  }
  for (int course = 1; course < courses; ++course)
    for (int wale = 0; wale < wales; ++wale) {
      const int above = course * segments + wale * per_loop, below = above - segments;
      made.crossings.push_back({above, above + per_loop / 4, below, below + per_loop - 1, -1});
      made.crossings.push_back({above + 3 * per_loop / 4 - 1, above + per_loop - 1, below, below + per_loop - 1, +1});
    }
  return made;
}

}  // namespace wale::testing
