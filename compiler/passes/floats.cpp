#include "compiler/passes/floats.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace wale {
namespace {

constexpr double float_depth = 1.35;   // diameters from the middle of the loops that it passes
constexpr double inlay_depth = 0.4;    // diameters from the middle of the loops half way up
constexpr double longest_climb = 2.5;  // courses: further, yarn goes up along the side
constexpr double turn_room = 0.9;      // wales beside the last loop that yarn led by misses passes
constexpr double same_sheet = 1.5;     // diameters: loops further off in depth are of the other face of a tube
constexpr double beside = 1.3;         // wales beside the outermost loops
constexpr double inside = 2.5;         // diameters from a tube's middle surface

/// A carrier that only makes room for others passes a needle or two there and back.
bool lead_somewhere(const std::vector<Leg>& legs) {
  return std::all_of(legs.begin(), legs.end(), [](const Leg& leg) { return leg.passed.size() > 2; });
}

}  // namespace

/// Between a loop's feet and its head.
Vec3 Floats::middle_of(int loop, double x) const {
  const Hanging& of = arrangement_.loops[static_cast<std::size_t>(loop)];
  const auto at = [&](int anchor) {
    return arrangement_.strip.near(x, arrangement_.anchors[static_cast<std::size_t>(anchor)].at);
  };
  return (at(of.feet) + at(of.head)) / 2;
}

std::vector<Vec3> Floats::way(const YarnStep& step, const Point& from, const Point& to, double x) const {
  if (step.legs.size() > 1 && lead_somewhere(step.legs)) {
    std::vector<Vec3> way = led_by_misses(step.legs, from.y, to.y, x);
    if (!way.empty() && goes_on_from_row_to_row(way, from.y, to.y)) return way;
  }
  if (step.waits) return arrangement_.strip.tube() ? up_the_inside(from, to) : round_the_side(from, to);
  return passed(step.legs.front().passed, from.y, to.y, x);
}

/// Between the beds, as in an inlay: half way up the loops that it passes, behind those of the front bed and before
/// those of the back bed, and round beside the last.
std::vector<Vec3> Floats::led_by_misses(const std::vector<Leg>& legs, const Vec3& from, const Vec3& to,
                                        double x) const {
  std::vector<Vec3> way;
  for (std::size_t k = 0; k < legs.size(); ++k) {
    const Leg& leg = legs[k];
    std::vector<Vec3> stops;
    for (const int loop : leg.passed) {
      Vec3 at = middle_of(loop, x);
      at.z() -= sign(loop) * inlay_depth * diameter_;
      stops.push_back(at);
    }
    std::sort(stops.begin(), stops.end(), [&](const Vec3& a, const Vec3& b) { return leg.side * (a.x() - b.x()) < 0; });
    if (stops.empty()) continue;
    if (k > 0) way.push_back(stops.front() - Vec3(leg.side * turn_room * size_.wale(), 0, 0));
    way.insert(way.end(), stops.begin(), stops.end());
    if (k + 1 < legs.size()) way.push_back(stops.back() + Vec3(leg.side * turn_room * size_.wale(), 0, 0));
  }
  std::erase_if(way, [&](const Vec3& at) { return (at - from).norm() < diameter_ || (at - to).norm() < diameter_; });
  return way;
}

bool Floats::goes_on_from_row_to_row(const std::vector<Vec3>& way, const Vec3& from, const Vec3& to) const {
  double at = from.y(), furthest = std::abs(to.y() - way.back().y());
  for (const Vec3& next : way) furthest = std::max(furthest, std::abs(next.y() - std::exchange(at, next.y())));
  return furthest < longest_climb * size_.pitch;
}

/// A yarn that was not knitted for some courses has waited beside the fabric, and comes up along its side.
std::vector<Vec3> Floats::round_the_side(const Point& from, const Point& to) const {
  const double side = from.dy.x() < 0 ? -1 : 1, low = std::min(from.y.y(), to.y.y()),
               high = std::max(from.y.y(), to.y.y());
  double outermost = std::max(side * from.y.x(), side * to.y.x());
  for (const Anchor& each : arrangement_.anchors)
    if (each.at.y() > low - size_.pitch && each.at.y() < high + size_.pitch)
      outermost = std::max(outermost, side * each.at.x());
  const double outside = side * (outermost + beside * size_.wale()), step = 0.15 * (to.y.y() - from.y.y());
  return {Vec3(outside, from.y.y() + step, from.y.z()), Vec3(outside, to.y.y() - step, to.y.z())};
}

/// Nor has a tube a side; there it waited inside.
std::vector<Vec3> Floats::up_the_inside(const Point& from, const Point& to) const {
  const Vec3 inwards(0, 0, -inside * diameter_);
  return {from.y + inwards + 0.2 * (to.y - from.y), to.y + inwards - 0.2 * (to.y - from.y)};
}

/// The points where a float lies behind the loops of the front bed that it passes, and before those of the back bed.
std::vector<Vec3> Floats::passed(const std::vector<int>& loops, const Vec3& from, const Vec3& to, double x) const {
  const double across = to.x() - from.x();
  std::map<double, Vec3> stops;  // by share of the way
  for (const int loop : loops) {
    const Vec3 middle = middle_of(loop, x);
    const double share = (middle.x() - from.x()) / across;
    if (!(share > 0.05 && share < 0.95)) continue;
    Vec3 at = from + share * (to - from);
    const bool between_sheets = middle.z() > std::min(from.z(), to.z()) && middle.z() < std::max(from.z(), to.z());
    if (std::abs(middle.z() - at.z()) > same_sheet * diameter_ && !between_sheets) continue;
    at.z() = middle.z() - sign(loop) * float_depth * diameter_;
    stops[share] = at;
  }
  std::vector<Vec3> points;
  for (const auto& [share, at] : stops) points.push_back(at);
  return points;
}

}  // namespace wale
