#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "compiler/passes.hpp"
#include "compiler/passes/edges.hpp"
#include "compiler/passes/hermite.hpp"
#include "compiler/passes/hung_loop.hpp"

namespace wale::passes {
namespace {

using Point = CurvePiece::Point;

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
constexpr double chain_depth = 2.95;    // of the loop pulled through both
constexpr double float_depth = 1.9;     // diameters from the middle of the loops that it passes
constexpr double free_depth = 0.88;     // diameters before the middle of the sheet
constexpr double inlay_depth = 0.4;     // diameters from the middle of the loops half way up
constexpr double longest_climb = 2.5;   // courses: further, yarn goes up along the side
constexpr double turn_room = 0.9;       // wales beside the last loop that yarn led by misses passes
constexpr double tuck_depth = 2.1;      // diameters behind the middle of the sheet: behind heads and sinkers
constexpr double aside = 1.1;           // of a loop that crosses another, in diameters
constexpr double turn_reach = 2;        // tangents of a turn, by its width
constexpr double turn_shrink = 0.7;     // turns are drawn wide and knitted straight
constexpr double same_sheet = 1.5;      // diameters: loops further off in depth are of the other face of a tube
constexpr double past_first = 0.65;     // in w: the legs of a split loop have passed the first loop pulled through it,
constexpr double before_second = 0.85;  // and come to the second
constexpr double beside = 1.3;          // wales beside the outermost loops
constexpr double inside = 2.5;          // diameters from a tube's middle surface

class Drawing {
 public:
  Drawing(const StitchGraph& graph, const Arrangement& arrangement, const LoopSize& size, double diameter,
          const Edges& edges)
      : graph_(graph), arrangement_(arrangement), size_(size), diameter_(diameter), edges_(edges) {}

  Curves draw() {
    find_widths();
    Curves curves;
    std::size_t step = 0;
    for (const YarnPath& yarn : graph_.yarns) {
      if (yarn.loops.empty()) continue;
      curves.yarns.push_back(draw_yarn(yarn, step));
      step += yarn.loops.size() - 1;
    }
    if (arrangement_.strip.tube()) wind(curves);
    return curves;
  }

 private:
  void wind(Curves& curves) const {
    for (YarnCurve& yarn : curves.yarns)
      for (CurvePiece& piece : yarn.pieces)
        piece.at = [strip = arrangement_.strip, flat = std::move(piece.at)](double u) { return strip.wind(flat(u)); };
  }

  const Hanging& hanging(int loop) const { return arrangement_.loops[static_cast<std::size_t>(loop)]; }
  const Anchor& anchor(int i) const { return arrangement_.anchors[static_cast<std::size_t>(i)]; }

  YarnCurve draw_yarn(const YarnPath& yarn, std::size_t first_step) {
    pieces_.clear();
    drawn_at_.clear();
    x_ = anchor(hanging(yarn.loops.front()).feet).at.x();
    for (std::size_t k = 0; k < yarn.loops.size(); ++k) {
      const YarnStep* before = k > 0 ? &arrangement_.steps[first_step + k - 1] : nullptr;
      const YarnStep* after = k + 1 < yarn.loops.size() ? &arrangement_.steps[first_step + k] : nullptr;
      if (before) x_ += before->turns ? 0 : hanging(before->to).heading * before->apart * size_.wale();
      x_ = feet_at(yarn.loops[k]).x();
      drawn_at_.push_back(x_);
      material_ = graph_.loops[static_cast<std::size_t>(yarn.loops[k])].carrier;
      draw_loop(yarn.loops[k], before, after, round_the_seam(yarn, k));
    }
    begin(yarn);
    finish(yarn);
    return {std::move(pieces_)};
  }

  /// A tube's strip passes every place once a round; yarn goes on from where it is.
  Vec3 nearby(const Vec3& at) const { return arrangement_.strip.near(x_, at); }
  Vec3 feet_at(int loop) const { return nearby(anchor(hanging(loop).feet).at); }
  Vec3 head_at(int loop) const { return nearby(anchor(hanging(loop).head).at); }

  /// Where the next loop of a row has its feet.
  Vec3 ahead(const YarnStep& step) const {
    const Vec3& from = anchor(hanging(step.from).feet).at;
    return arrangement_.strip.near(from.x(), anchor(hanging(step.to).feet).at) - from;
  }

  /// One foot of a row goes over into the next where the loops lie side by side.
  bool side_by_side(const YarnStep& step) const {
    if (step.turns || step.apart != 1) return false;
    const Vec3 apart = ahead(step);
    const double wales = hanging(step.to).heading * apart.x() / size_.wale();
    return wales > 0.4 && wales < 1.8 && std::abs(apart.y()) < size_.pitch && std::abs(apart.z()) < 2 * diameter_;
  }

  struct Width {
    double left = 1, right = 1;
  };

  /// Loops of a row share the room between them, so that their feet meet.
  void find_widths() {
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
  Width width_of_head(const Anchor& of) const {
    if (of.feet.empty()) return {};
    const Width feet = widths_[static_cast<std::size_t>(of.feet.front())];
    const double mean = (feet.left + feet.right) / 2;
    return {mean, mean};
  }

  Footing footing(int anchor_index, int loop, bool head) const {
    const Anchor& of = anchor(anchor_index);
    const std::vector<int>& layers = head ? of.heads : of.feet;
    const auto place = std::find(layers.begin(), layers.end(), loop) - layers.begin();
    const auto count = static_cast<double>(layers.size());
    const auto thickest = static_cast<double>(std::max(of.heads.size(), of.feet.size()));
    const Width width = head ? width_of_head(of) : widths_[static_cast<std::size_t>(loop)];
    Footing footing{nearby(of.at), of.up, width.left, width.right, 1 + deeper * (thickest - 1), 0};
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
  void lay_along_edge(int loop, Footing& footing) const {
    const ChainHead& by = footing.forward * hanging(loop).sign < 0 ? chain_behind : chain_before;
    const Vec3 ahead = hanging(loop).heading * Vec3(footing.up.y(), -footing.up.x(), 0);
    footing.at += by.raise * size_.pitch * footing.up;
    footing.up = std::cos(by.tilt) * footing.up + std::sin(by.tilt) * ahead;
    footing.forward = std::copysign(by.apart * diameter_, footing.forward);
    footing.depth = by.depth;
  }

  /// All on one side: the feet of a tuck behind the heads and sinkers that it passes, a head that is let go where its
  /// needle was.
  void lay_aside(int loop, double forward, Footing& footing) const {
    footing.depth = 0;
    footing.forward += hanging(loop).sign * forward * diameter_;
  }

  bool holds_chain(const Anchor& of) const {
    return std::any_of(of.heads.begin(), of.heads.end(), [this](int head) { return hanging(head).chained; });
  }

  Bearing bearing(int loop) const {
    const Hanging& of = hanging(loop);
    return bearing(loop, of.via >= 0 ? of.via : of.head);
  }

  Bearing bearing(int loop, int head) const {
    const Hanging& of = hanging(loop);
    Bearing bearing{footing(of.feet, loop, false), footing(head, loop, true), {of.sign, of.sign}, 0};
    const std::vector<int>& above = anchor(head).feet;
    if (!above.empty()) bearing.signs.above = hanging(above.front()).sign;
    // A loop out of nothing lies behind (or before) those that it hangs with all the way.
    if (!of.tucked && anchor(of.feet).heads.empty() && anchor(of.feet).feet.size() == 1)
      bearing.feet.forward = bearing.head.forward;
    bearing.aside = of.passes * aside * diameter_;
    return bearing;
  }

  /// The loops of the yarn's first course, and of its last.
  std::size_t first_course(const YarnPath& yarn) const {
    const auto stitched = [this](int loop) { return !graph_.loops[static_cast<std::size_t>(loop)].through.empty(); };
    return static_cast<std::size_t>(std::find_if(yarn.loops.begin(), yarn.loops.end(), stitched) - yarn.loops.begin());
  }
  std::size_t last_course(const YarnPath& yarn) const {
    std::size_t from = yarn.loops.size();
    while (from > 0 && graph_.loops[static_cast<std::size_t>(yarn.loops[from - 1])].held) --from;
    return from;
  }

  /// Where a tube's yarn leads into its edges it leans on the loop beside it in the same course; else -1.
  int round_the_seam(const YarnPath& yarn, std::size_t k) const {
    if (!arrangement_.strip.tube()) return -1;
    if (k == 0 && edges_.cast_on) return yarn.loops[first_course(yarn) - 1];
    if (k + 1 == yarn.loops.size() && edges_.bind_off) return yarn.loops[last_course(yarn)];
    return -1;
  }

  Bearing beside_with_signs_of(Bearing own, int other, double wales) const {
    const Vec3 along = wales * size_.wale() * Vec3::UnitX();
    own.feet.at += along;
    own.head.at += along;
    own.signs = bearing(other).signs;
    return own;
  }

  void draw_loop(int loop, const YarnStep* before, const YarnStep* after, int over_the_seam) {
    HungLoop shape{bearing(loop), {}, {}};
    const int heading = hanging(loop).heading;
    if (over_the_seam >= 0) {
      const double side = before ? heading : -heading;
      (side > 0 ? shape.right : shape.left) = beside_with_signs_of(shape.here, over_the_seam, side);
    }
    const bool joined = before && side_by_side(*before);
    if (joined) (heading > 0 ? shape.left : shape.right) = bearing(before->from);
    if (after && side_by_side(*after)) (heading > 0 ? shape.right : shape.left) = bearing(after->to);
    if (before && !joined) {
      const Curve3 start = hung_point(size_, shape, -2 * heading);
      join(*before, {start.y, heading * start.dy});
    }
    if (hanging(loop).via < 0)
      add_part(shape, loop, -2, 2);
    else
      add_split(shape, loop);
  }

  double stitch_length(int loop) const { return graph_.loops[static_cast<std::size_t>(loop)].stitch_length; }

  /// A loop from `from` to `to`, in w as it lies from left to right if it heads there.
  void add_part(const HungLoop& shape, int loop, double from, double to) {
    const double h = hanging(loop).heading;
    pieces_.push_back({[=, size = size_](double u) {
                         const Curve3 c = hung_point(size, shape, h * (from + u * (to - from)));
                         return Point{c.y, (to - from) * h * c.dy};
                       },
                       loop, material_, stitch_length(loop) * (to - from) / 4, 1});
  }

  /// A loop through which two others were pulled, one after the other: its legs pass the first as any loop's, go on,
  /// and its head holds the second.
  void add_split(const HungLoop& shape, int loop) {
    HungLoop upper = shape;
    upper.here = bearing(loop, hanging(loop).head);
    upper.here.feet = upper.here.head;
    upper.here.feet.at -= size_.pitch * upper.here.feet.up;
    add_part(shape, loop, -2, -past_first);
    add_leg(shape, -past_first, upper, -before_second, loop);
    add_part(upper, loop, -before_second, before_second);
    add_leg(upper, before_second, shape, past_first, loop);
    add_part(shape, loop, past_first, 2);
  }

  void add_leg(const HungLoop& below, double from, const HungLoop& above, double to, int loop) {
    const double h = hanging(loop).heading;
    const Curve3 a = hung_point(size_, below, h * from), b = hung_point(size_, above, h * to);
    const double reach = (b.y - a.y).norm();
    const Point start{a.y, reach * h * a.dy.normalized()}, end{b.y, reach * h * b.dy.normalized()};
    pieces_.push_back({[=](double u) { return hermite(start, end, u); }, loop, material_, 0, 1});
  }

  /// From where the yarn is to the next loop, past what hangs between.
  void join(const YarnStep& step, const Point& to) {
    const Point from = pieces_.back().at(1);
    std::vector<Point> stops{from};
    for (const Vec3& at : on_the_way(step, from, to)) stops.push_back({at, Vec3::Zero()});
    stops.push_back(to);
    const bool straight = stops.size() == 2;
    const double reach = (step.turns && straight ? turn_reach : 1) * std::max((to.y - from.y).norm(), diameter_);
    for (std::size_t k = 1; k + 1 < stops.size(); ++k) stops[k].dy = (stops[k + 1].y - stops[k - 1].y) / 2;
    const auto length = [&](std::size_t k) { return straight ? reach : (stops[k + 1].y - stops[k].y).norm(); };
    stops.front().dy = length(0) * from.dy.normalized();
    stops.back().dy = length(stops.size() - 2) * to.dy.normalized();
    for (std::size_t k = 0; k + 1 < stops.size(); ++k)
      pieces_.push_back({[a = stops[k], b = stops[k + 1]](double u) { return hermite(a, b, u); }, -1, material_, 0,
                         step.turns ? turn_shrink : 1});
  }

  std::vector<Vec3> on_the_way(const YarnStep& step, const Point& from, const Point& to) const {
    if (step.legs.size() > 1 && lead_somewhere(step.legs)) {
      std::vector<Vec3> way = led_by_misses(step, from.y, to.y);
      if (!way.empty() && goes_on_from_row_to_row(way, from.y, to.y)) return way;
    }
    if (step.waits) return arrangement_.strip.tube() ? up_the_inside(from, to) : round_the_side(from, to);
    return passed(step.legs.front().passed, from.y, to.y);
  }

  /// Between the beds, as in an inlay: half way up the loops that it passes, behind those of the front bed and before
  /// those of the back bed, and round beside the last.
  std::vector<Vec3> led_by_misses(const YarnStep& step, const Vec3& from, const Vec3& to) const {
    std::vector<Vec3> way;
    for (std::size_t k = 0; k < step.legs.size(); ++k) {
      const Leg& leg = step.legs[k];
      std::vector<Vec3> stops;
      for (const int loop : leg.passed) {
        Vec3 at = (feet_at(loop) + head_at(loop)) / 2;
        at.z() -= hanging(loop).sign * inlay_depth * diameter_;
        stops.push_back(at);
      }
      std::sort(stops.begin(), stops.end(),
                [&](const Vec3& a, const Vec3& b) { return leg.side * (a.x() - b.x()) < 0; });
      if (stops.empty()) continue;
      if (k > 0) way.push_back(stops.front() - Vec3(leg.side * turn_room * size_.wale(), 0, 0));
      way.insert(way.end(), stops.begin(), stops.end());
      if (k + 1 < step.legs.size()) way.push_back(stops.back() + Vec3(leg.side * turn_room * size_.wale(), 0, 0));
    }
    std::erase_if(way, [&](const Vec3& at) { return (at - from).norm() < diameter_ || (at - to).norm() < diameter_; });
    return way;
  }

  /// A carrier that only makes room for others passes a needle or two there and back.
  static bool lead_somewhere(const std::vector<Leg>& legs) {
    return std::all_of(legs.begin(), legs.end(), [](const Leg& leg) { return leg.passed.size() > 2; });
  }

  bool goes_on_from_row_to_row(const std::vector<Vec3>& way, const Vec3& from, const Vec3& to) const {
    double at = from.y(), furthest = std::abs(to.y() - way.back().y());
    for (const Vec3& next : way) furthest = std::max(furthest, std::abs(next.y() - std::exchange(at, next.y())));
    return furthest < longest_climb * size_.pitch;
  }

  /// A yarn that was not knitted for some courses has waited beside the fabric, and comes up along its side.
  std::vector<Vec3> round_the_side(const Point& from, const Point& to) const {
    const double side = from.dy.x() < 0 ? -1 : 1, low = std::min(from.y.y(), to.y.y()),
                 high = std::max(from.y.y(), to.y.y());
    double outermost = std::max(side * from.y.x(), side * to.y.x());
    for (const Anchor& each : arrangement_.anchors)
      if (each.at.y() > low - size_.pitch && each.at.y() < high + size_.pitch)
        outermost = std::max(outermost, side * each.at.x());
    const double x = side * (outermost + beside * size_.wale()), step = 0.15 * (to.y.y() - from.y.y());
    return {Vec3(x, from.y.y() + step, from.y.z()), Vec3(x, to.y.y() - step, to.y.z())};
  }

  /// Nor has a tube a side; there it waited inside.
  std::vector<Vec3> up_the_inside(const Point& from, const Point& to) const {
    const Vec3 inwards(0, 0, -inside * diameter_);
    return {from.y + inwards + 0.2 * (to.y - from.y), to.y + inwards - 0.2 * (to.y - from.y)};
  }

  /// The points where a float lies behind the loops of the front bed that it passes, and before those of the back bed.
  std::vector<Vec3> passed(const std::vector<int>& loops, const Vec3& from, const Vec3& to) const {
    const double across = to.x() - from.x();
    std::map<double, Vec3> stops;  // by share of the way
    for (const int loop : loops) {
      const Hanging& of = hanging(loop);
      const Vec3 middle = (feet_at(loop) + head_at(loop)) / 2;
      const double share = (middle.x() - from.x()) / across;
      if (!(share > 0.05 && share < 0.95)) continue;
      Vec3 at = from + share * (to - from);
      const bool between_sheets = middle.z() > std::min(from.z(), to.z()) && middle.z() < std::max(from.z(), to.z());
      if (std::abs(middle.z() - at.z()) > same_sheet * diameter_ && !between_sheets) continue;
      at.z() = middle.z() - of.sign * float_depth * diameter_;
      stops[share] = at;
    }
    std::vector<Vec3> points;
    for (const auto& [share, at] : stops) points.push_back(at);
    return points;
  }

  EdgeStyle edge_style(const Point& stitch) const { return {size_, diameter_, edges_.yarns, stitch}; }

  /// The course of which the yarn's loops `from` to `to` (not included) are.
  EdgeRow row(const YarnPath& yarn, std::size_t from, std::size_t to) const {
    EdgeRow row;
    row.heading = hanging(yarn.loops[from]).heading;
    for (std::size_t k = from; k < to; ++k)
      row.wales.push_back({hanging(yarn.loops[k]).sign, graph_.loops[static_cast<std::size_t>(yarn.loops[k])].carrier});
    if (row.heading < 0) std::reverse(row.wales.begin(), row.wales.end());
    row.first = row.heading > 0 ? drawn_at_[from] : drawn_at_[to - 1];
    const Vec3& feet = anchor(hanging(yarn.loops[from]).feet).at;
    row.level = arrangement_.strip.near(drawn_at_[from], feet).y() + size_.pitch / 2;
    return row;
  }

  void begin(const YarnPath& yarn) {
    const Point first = pieces_.front().at(0);
    std::vector<CurvePiece> before;
    if (edges_.cast_on) {
      before = cast_on(row(yarn, 0, first_course(yarn)), edge_style(first));
    } else {
      const Vec3 in = tail_length() * first.dy.normalized();
      before.push_back(tail({first.y - in, in}, {first.y, in}, pieces_.front().material));
    }
    pieces_.insert(pieces_.begin(), before.begin(), before.end());
  }

  void finish(const YarnPath& yarn) {
    const Point last = pieces_.back().at(1);
    if (!edges_.bind_off) {
      const Vec3 out = tail_length() * last.dy.normalized();
      pieces_.push_back(tail({last.y, out}, {last.y + out, out}, material_));
      return;
    }
    const EdgeRow course = row(yarn, last_course(yarn), yarn.loops.size());
    const auto after =
        arrangement_.strip.tube() ? bind_off_round(course, edge_style(last)) : bind_off_flat(course, edge_style(last));
    pieces_.insert(pieces_.end(), after.begin(), after.end());
  }

  double tail_length() const { return size_.wale() / 2; }

  /// A loose end, on from the first or the last loop and away from the fabric's middle.
  static CurvePiece tail(const Point& a, const Point& b, int material) {
    return {[=](double u) { return hermite(a, b, u); }, -1, material, 0, 1};
  }

  const StitchGraph& graph_;
  const Arrangement& arrangement_;
  LoopSize size_;
  double diameter_;
  Edges edges_;
  int material_ = 0;
  double x_ = 0;                  // where the yarn is, along the strip
  std::vector<double> drawn_at_;  // of each loop of the yarn
  std::vector<Width> widths_;     // of each loop's feet
  std::vector<CurvePiece> pieces_;
};

}  // namespace

Curves draw(const StitchGraph& graph, const Arrangement& arrangement, const LoopSize& size, double diameter,
            const Edges& edges) {
  return Drawing(graph, arrangement, size, diameter, edges).draw();
}

}  // namespace wale::passes
