#include "tests/stability/renumbered.hpp"

#include <algorithm>
#include <numeric>

namespace wale::stability {
namespace {

/// By segment: which it becomes.
std::vector<int> new_segments(const Fabric& fabric) {
  std::vector<int> becomes(fabric.segments.size());
  int next = 0;
  for (auto yarn = fabric.yarns.rbegin(); yarn != fabric.yarns.rend(); ++yarn)
    for (int i = 0; i < yarn->segments; ++i) becomes[static_cast<std::size_t>(yarn->first_segment + i)] = next++;
  return becomes;
}

Fabric turned_about(const Fabric& fabric, const std::vector<int>& becomes) {
  Fabric turned = fabric;
  turned.points = last_yarn_first(fabric, fabric.points);
  std::reverse(turned.yarns.begin(), turned.yarns.end());
  int point = 0, segment = 0;
  for (Yarn& yarn : turned.yarns) {
    yarn.first_point = std::exchange(point, point + yarn.points());
    yarn.first_segment = std::exchange(segment, segment + yarn.segments);
  }
  for (std::size_t i = 0; i < becomes.size(); ++i) {
    Segment& moved = turned.segments[static_cast<std::size_t>(becomes[i])];
    moved = fabric.segments[i];
    moved.yarn = static_cast<int>(fabric.yarns.size()) - 1 - moved.yarn;
  }
  return turned;
}

}  // namespace

Points last_yarn_first(const Fabric& fabric, const Points& q) {
  Points turned(3, q.cols());
  Eigen::Index next = 0;
  for (auto yarn = fabric.yarns.rbegin(); yarn != fabric.yarns.rend(); ++yarn) {
    turned.middleCols(next, yarn->points()) = q.middleCols(yarn->first_point, yarn->points());
    next += yarn->points();
  }
  return turned;
}

HardScene renumbered(const HardScene& hard) {
  HardScene turned = hard;
  Scene& scene = turned.scene;
  const std::vector<int> becomes = new_segments(scene.fabric);
  const auto renumber = [&](int& segment) { segment = becomes[static_cast<std::size_t>(segment)]; };
  const auto renumber_all = [&](std::vector<int>& segments) {
    std::for_each(segments.begin(), segments.end(), renumber);
  };
  const int last_yarn = static_cast<int>(scene.fabric.yarns.size()) - 1;
  scene.fabric = turned_about(scene.fabric, becomes);
  for (auto* ends : {&scene.gauge.wale_ends, &scene.gauge.course_ends})
    for (std::vector<int>& end : *ends) renumber_all(end);
  for (Crossing& crossing : scene.crossings)
    for (int* segment : {&crossing.side_first, &crossing.side_last, &crossing.loop_first, &crossing.loop_last})
      renumber(*segment);
  for (Clamp& clamp : scene.clamps) clamp.yarn = last_yarn - clamp.yarn;
  for (Closing& closing : turned.closings) closing.yarn = last_yarn - closing.yarn;
  for (Stage& stage : scene.stages)
    for (EffectSpec& effect : stage.effects) {
      if (auto* tether = std::get_if<Tether>(&effect)) renumber_all(tether->segments);
      if (auto* knots = std::get_if<Knots>(&effect))
        for (Knot& knot : knots->knots) {
          renumber(knot.segment_a);
          renumber(knot.segment_b);
        }
    }
  return turned;
}

}  // namespace wale::stability
