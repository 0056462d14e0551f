#include "compiler/passes/uprights.hpp"

#include <cmath>

namespace wale {
namespace {

const Vec3& at(const Arrangement& of, int anchor) { return of.anchors[static_cast<std::size_t>(anchor)].at; }

std::vector<Vec3> leans(const Arrangement& of, const LoopSize& size) {
  std::vector<Vec3> lean(of.anchors.size(), Vec3(0, size.pitch, 0));
  for (const Hanging& loop : of.loops) {
    if (loop.passes) continue;
    Vec3 rise = of.strip.near(at(of, loop.feet).x(), at(of, loop.head)) - at(of, loop.feet);
    rise.z() = 0;
    lean[static_cast<std::size_t>(loop.feet)] += rise;
    lean[static_cast<std::size_t>(loop.head)] += rise;
  }
  return lean;
}

/// From left to right along the row that has its feet at each anchor.
std::vector<Vec3> rows(const Arrangement& of, const std::vector<int>& raised, const LoopSize& size) {
  std::vector<Vec3> row(of.anchors.size(), Vec3::Zero());
  for (const YarnStep& step : of.steps) {
    const auto first = static_cast<std::size_t>(step.from), second = static_cast<std::size_t>(step.to);
    const Hanging &from = of.loops[first], &to = of.loops[second];
    if (step.turns || step.apart > 2 || raised[first] != raised[second]) continue;
    const Vec3& at_from = at(of, from.feet);
    const Vec3 along = to.heading * (of.strip.near(at_from.x(), at(of, to.feet)) - at_from);
    if (along.x() <= 0 || std::abs(along.y()) > size.pitch) continue;
    for (const int feet : {from.feet, to.feet}) row[static_cast<std::size_t>(feet)] += Vec3(along.x(), along.y(), 0);
  }
  return row;
}

}  // namespace

void turn_up(Arrangement& of, const std::vector<int>& raised, const LoopSize& size) {
  const std::vector<Vec3> lean = leans(of, size), row = rows(of, raised, size);
  for (std::size_t i = 0; i < lean.size(); ++i) {
    const Vec3 up = row[i].norm() > 1e-3 * size.pitch ? Vec3(-row[i].y(), row[i].x(), 0) : lean[i];
    if (up.norm() > 1e-3 * size.pitch) of.anchors[i].up = up.normalized();
  }
}

}  // namespace wale
