#include "compiler/passes/hung_loop.hpp"

#include "compiler/passes/smooth_step.hpp"

namespace wale {
namespace {

/// A point that the feet or the head carry along rigidly, `below` or above the middle of the loop by half a pitch.
Curve3 carried(const Footing& by, const Curve3& flat, double from_middle) {
  const Vec3 right = (flat.y.x() < 0 ? by.left : by.right) * Vec3(by.up.y(), -by.up.x(), 0);
  Curve3 moved;
  moved.y = by.at + flat.y.x() * right + (flat.y.y() - from_middle) * by.up;
  moved.y.z() += by.depth * flat.y.z() + by.forward;
  moved.dy = flat.dy.x() * right + flat.dy.y() * by.up;
  moved.dy.z() += by.depth * flat.dy.z();
  return moved;
}

Curve3 mix(const Curve3& a, const Curve3& b, const Smooth& share, double speed) {
  return {a.y + share.value * (b.y - a.y), a.dy + share.value * (b.dy - a.dy) + share.slope * speed * (b.y - a.y)};
}

/// From the feet's hold to the head's between the heights of both.
Curve3 stretched(const LoopSize& size, const Bearing& between, const Curve3& flat) {
  const double height = flat.y.y() / size.pitch + 0.5, climb = flat.dy.y() / size.pitch;
  Curve3 point = mix(carried(between.feet, flat, -size.pitch / 2), carried(between.head, flat, size.pitch / 2),
                     smooth_step(height), climb);
  const Smooth up = smooth_step(2 * height), down = smooth_step(2 - 2 * height);
  point.y.z() += between.aside * up.value * down.value;
  point.dy.z() += between.aside * 2 * climb * (up.slope * down.value - up.value * down.slope);
  return point;
}

/// The same point seen from the loop a wale further to the right (or left).
Curve3 seen_from(double wale, const Curve3& flat) { return {flat.y - Vec3(wale, 0, 0), flat.dy}; }

}  // namespace

Curve3 hung_point(const LoopSize& size, const HungLoop& loop, double w) {
  const auto signs = [&](const std::optional<Bearing>& beside) { return beside ? beside->signs : loop.here.signs; };
  const Curve3 flat = loop_point(size, signs(loop.left), loop.here.signs, signs(loop.right), w);
  const Curve3 own = stretched(size, loop.here, flat);
  // In the middle of a sinker both neighbours have an equal say.
  const Smooth share = share_of_right(w > 0 ? w - 2 : w + 2);
  if (w > 0 && loop.right && share.value > 0)
    return mix(own, stretched(size, *loop.right, seen_from(size.wale(), flat)), share, 1);
  if (w < 0 && loop.left && share.value < 1)
    return mix(stretched(size, *loop.left, seen_from(-size.wale(), flat)), own, share, 1);
  return own;
}

}  // namespace wale
