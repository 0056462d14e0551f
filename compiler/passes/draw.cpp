#include <algorithm>
#include <cmath>

#include "compiler/passes.hpp"
#include "compiler/passes/bearings.hpp"
#include "compiler/passes/edges.hpp"
#include "compiler/passes/floats.hpp"
#include "compiler/passes/hermite.hpp"

namespace wale::passes {
namespace {

using Point = CurvePiece::Point;

constexpr double turn_reach = 2;        // tangents of a turn, by its width
constexpr double turn_shrink = 0.7;     // turns are drawn wide and knitted straight
constexpr double past_first = 0.65;     // in w: the legs of a split loop have passed the first loop pulled through it,
constexpr double before_second = 0.85;  // and come to the second

class Drawing {
 public:
  Drawing(const StitchGraph& graph, const Arrangement& arrangement, const LoopSize& size, double diameter,
          const Edges& edges)
      : graph_(graph),
        arrangement_(arrangement),
        size_(size),
        diameter_(diameter),
        edges_(edges),
        bearings_(graph, arrangement, size_, diameter),
        floats_(arrangement, size, diameter) {}

  Curves draw() {
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
  Vec3 feet_at(int loop) const { return arrangement_.strip.near(x_, anchor(hanging(loop).feet).at); }
  Bearing bearing(int loop) const { return bearings_.of(loop, x_); }

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
    const bool joined = before && bearings_.side_by_side(*before);
    if (joined) (heading > 0 ? shape.left : shape.right) = bearing(before->from);
    if (after && bearings_.side_by_side(*after)) (heading > 0 ? shape.right : shape.left) = bearing(after->to);
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
    upper.here = bearings_.of(loop, hanging(loop).head, x_);
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
    for (const Vec3& at : floats_.way(step, from, to, x_)) stops.push_back({at, Vec3::Zero()});
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
  Bearings bearings_;
  Floats floats_;
  int material_ = 0;
  double x_ = 0;                  // where the yarn is, along the strip
  std::vector<double> drawn_at_;  // of each loop of the yarn
  std::vector<CurvePiece> pieces_;
};

}  // namespace

Curves draw(const StitchGraph& graph, const Arrangement& arrangement, const LoopSize& size, double diameter,
            const Edges& edges) {
  return Drawing(graph, arrangement, size, diameter, edges).draw();
}

}  // namespace wale::passes
