#include "compiler/passes/bearings.hpp"

#include <algorithm>
#include <cmath>

namespace wale {
namespace {

constexpr double deeper = 0.6;  // a loop reaches by so much deeper for each further one that hangs with it
constexpr double narrowest = 0.5, widest = 1.25;  // half a loop, of a regular one

/// How the head of a loop in a bind-off lies with that of the loop with which it is bound off.
struct ChainHead {
  double raise = 0;  ///< courses higher
  double tilt = 0;   ///< along the edge, rad
  double apart = 0;  ///< from the middle between the two, diameters
  double depth = 0;  ///< of its legs and its head, in those of a single loop
};
// Found by search for the most room.
constexpr ChainHead chain_behind{0, 1.05, 1, 0.2}, chain_before{0.3, 0.7, 0.5, 1.6};
constexpr double chain_depth = 2.95;  // of the loop pulled through both
constexpr double free_depth = 0.88;   // diameters before the middle of the sheet
constexpr double tuck_depth = 2.1;    // diameters behind the middle of the sheet: behind heads and sinkers
constexpr double aside = 1.1;         // of a loop that crosses another, in diameters

}  // namespace

Bearings::Bearings(const StitchGraph& graph, const Arrangement& arrangement, const LoopSize& size, double diameter)
    : graph_(graph), arrangement_(arrangement), size_(size), diameter_(diameter) {
  find_widths();
}

/// Where the next loop of a row has its feet.
Vec3 Bearings::ahead(const YarnStep& step) const {
  const Vec3& from = anchor(hanging(step.from).feet).at;
  return arrangement_.strip.near(from.x(), anchor(hanging(step.to).feet).at) - from;
}

bool Bearings::side_by_side(const YarnStep& step) const {
  if (step.turns || step.apart != 1) return false;
  const Vec3 apart = ahead(step);
  const double wales = hanging(step.to).heading * apart.x() / size_.wale();
  return wales > 0.4 && wales < 1.8 && std::abs(apart.y()) < size_.pitch && std::abs(apart.z()) < 2 * diameter_;
}

/// Loops of a row share the room between them, so that their feet meet.
void Bearings::find_widths() {
  widths_.assign(arrangement_.loops.size(), {});
  for (const YarnStep& step : arrangement_.steps) {
    if (!side_by_side(step)) continue;
    const double share = std::clamp(std::abs(ahead(step).x()) / size_.wale(), narrowest, widest);
    const bool rightwards = hanging(step.to).heading > 0;
    widths_[static_cast<std::size_t>(rightwards ? step.from : step.to)].right = share;
    widths_[static_cast<std::size_t>(rightwards ? step.to : step.from)].left = share;
  }
}

/// Of the loops that hang at an anchor: that of what is pulled through them.
Bearings::Width Bearings::width_of_head(const Anchor& of) const {
  if (of.feet.empty()) return {};
  const Width feet = widths_[static_cast<std::size_t>(of.feet.front())];
  const double mean = (feet.left + feet.right) / 2;
  return {mean, mean};
}

Footing Bearings::footing(int anchor_index, int loop, bool head, double x) const {
  const Anchor& of = anchor(anchor_index);
  const std::vector<int>& layers = head ? of.heads : of.feet;
  const auto place = std::find(layers.begin(), layers.end(), loop) - layers.begin();
  const auto count = static_cast<double>(layers.size());
  const auto thickest = static_cast<double>(std::max(of.heads.size(), of.feet.size()));
  const Width width = head ? width_of_head(of) : widths_[static_cast<std::size_t>(loop)];
  Footing footing{arrangement_.strip.near(x, of.at), of.up, width.left, width.right, 1 + deeper * (thickest - 1), 0};
  if (place < static_cast<std::ptrdiff_t>(layers.size()))
    footing.forward = diameter_ * ((count - 1) / 2 - static_cast<double>(place));
  if (head && hanging(loop).chained) lay_along_edge(loop, footing);
  if (!head && hanging(loop).tucked) lay_aside(loop, -tuck_depth, footing);
  if (head && of.feet.empty() && !graph_.loops[static_cast<std::size_t>(loop)].held)
    lay_aside(loop, free_depth, footing);
  if (!head && of.heads.size() > 1 && holds_chain(of)) footing.depth = chain_depth;
  return footing;
}

/// The head of a loop in a bind-off.
void Bearings::lay_along_edge(int loop, Footing& footing) const {
  const ChainHead& by = footing.forward * hanging(loop).sign < 0 ? chain_behind : chain_before;
  const Vec3 ahead = hanging(loop).heading * Vec3(footing.up.y(), -footing.up.x(), 0);
  footing.at += by.raise * size_.pitch * footing.up;
  footing.up = std::cos(by.tilt) * footing.up + std::sin(by.tilt) * ahead;
  footing.forward = std::copysign(by.apart * diameter_, footing.forward);
  footing.depth = by.depth;
}

/// All on one side: the feet of a tuck behind the heads and sinkers that it passes, a head that is let go where its
/// needle was.
void Bearings::lay_aside(int loop, double forward, Footing& footing) const {
  footing.depth = 0;
  footing.forward += hanging(loop).sign * forward * diameter_;
}

bool Bearings::holds_chain(const Anchor& of) const {
  return std::any_of(of.heads.begin(), of.heads.end(), [this](int head) { return hanging(head).chained; });
}

Bearing Bearings::of(int loop, double x) const {
  const Hanging& of = hanging(loop);
  return this->of(loop, of.via >= 0 ? of.via : of.head, x);
}

Bearing Bearings::of(int loop, int head, double x) const {
  const Hanging& of = hanging(loop);
  Bearing bearing{footing(of.feet, loop, false, x), footing(head, loop, true, x), {of.sign, of.sign}, 0};
  const std::vector<int>& above = anchor(head).feet;
  if (!above.empty()) bearing.signs.above = hanging(above.front()).sign;
  // A loop out of nothing lies behind (or before) those that it hangs with all the way.
  if (!of.tucked && anchor(of.feet).heads.empty() && anchor(of.feet).feet.size() == 1)
    bearing.feet.forward = bearing.head.forward;
  bearing.aside = of.passes * aside * diameter_;
  return bearing;
}

}  // namespace wale
