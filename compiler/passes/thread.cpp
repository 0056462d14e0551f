#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/passes.hpp"
#include "compiler/passes/chain_shape.hpp"
#include "compiler/passes/strip.hpp"

namespace wale::passes {
namespace {

using Point = CurvePiece::Point;

constexpr double chain_radius = 1.3;  // of the cast-on and bind-off spirals, in diameters
// Beyond what the stitches shrink: joins are drawn in wide half circles and knitted straight, and a chain pulled tight
// keeps the heads that it holds from turning over.
constexpr double join_shrink = 0.7;
constexpr double chain_shrink = 0.9;

/// How a tube's yarn rises from the foot of its last loop into the bind-off, between that loop and the next one; found
/// by search for the most room. In diameters.
struct Rise {
  double ahead = 0.26, up = -1.19;  ///< of the middle between foot and spiral
  double aside = 0.4;               ///< away from the leg and the head on either side, if these lie on one side
  double leave = 2.3, middle = 4.05, arrive = 0.5;  ///< lengths of the tangents
};

/// Draws a layout as one yarn in the strip: cast-on spiral, courses in knitting order joined at the sides, bind-off
/// spiral. A tube's courses follow each other in x without end.
class Drawing {
 public:
  Drawing(const Layout& layout, LoopSize size, double diameter, int materials)
      : layout_(layout), size_(size), diameter_(diameter), chain_(chain_radius * diameter), materials_(materials) {}

  std::vector<CurvePiece> draw() {
    if (layout_.cast_on) cast_on();
    for (int course = 0; course < layout_.courses; ++course) {
      if (!pieces_.empty() && (course == 0 || !tube())) join(course);
      for (int k = 0; k < layout_.wales; ++k) draw_loop(course, forward(course) ? k : layout_.wales - 1 - k);
    }
    if (layout_.bind_off) bind_off();
    return std::move(pieces_);
  }

 private:
  bool tube() const { return layout_.form == Form::tube; }
  bool forward(int course) const { return layout_.from_left[static_cast<std::size_t>(course)] != 0; }
  int heading(int course) const { return forward(course) ? 1 : -1; }
  const PlacedLoop& at(int course, int wale) const {
    return layout_.rows[static_cast<std::size_t>(course)][static_cast<std::size_t>(wale)];
  }

  /// Signs of the loop at a wale of a course; beyond the sides of a flat fabric those of the last loop, beyond the
  /// seam of a tube those of the course that goes on there.
  LoopSigns signs(int course, int wale) const {
    if (tube() && (wale < 0 || wale >= layout_.wales)) {
      const int side = wale < 0 ? -1 : 1;
      const int next = std::clamp(course + side * heading(course), 0, layout_.courses - 1);
      return signs(next, wale - side * layout_.wales);
    }
    const PlacedLoop& placed = at(course, std::clamp(wale, 0, layout_.wales - 1));
    return {placed.sign, placed.sign_above};
  }

  double centre_x(int course, int wale) const {
    return size_.wale() * (wale + (tube() ? heading(course) * course * layout_.wales : 0));
  }
  double level(int course) const { return tube() ? 0 : size_.pitch * course; }

  Point loop_at(int course, int wale, double w) const {
    Curve3 c = loop_point(size_, signs(course, wale - 1), signs(course, wale), signs(course, wale + 1), w);
    return {c.y + Vec3(centre_x(course, wale), level(course), 0), c.dy};
  }

  Point end() const { return pieces_.back().at(1); }

  void add(std::function<Point(double)> at, int material, const PlacedLoop* of = nullptr) {
    CurvePiece piece{std::move(at), -1, material, 0, 1};
    if (of) {
      piece.stitch = of->loop;
      piece.stitch_length = of->stitch_length;
    }
    pieces_.push_back(std::move(piece));
  }

  void draw_loop(int course, int wale) {
    const PlacedLoop& placed = at(course, wale);
    const LoopSigns left = signs(course, wale - 1), here = signs(course, wale), right = signs(course, wale + 1);
    const Vec3 centre(centre_x(course, wale), level(course), 0);
    const double h = heading(course);
    add(
        [=, size = size_](double u) {
          const Curve3 c = loop_point(size, left, here, right, h * (4 * u - 2));
          return Point{centre + c.y, 4 * h * c.dy};
        },
        placed.material, &placed);
  }

  /// A cubic between two directions; the longer the reach, the wider it swings out.
  void bridge(const Point& from, const Point& to, double reach_from, double reach_to, int material) {
    const Point a{from.y, reach_from * from.dy.normalized()}, b{to.y, reach_to * to.dy.normalized()};
    add([a, b](double u) { return hermite(a, b, u); }, material);
    pieces_.back().shrink = join_shrink;
  }

  Point start_of(int course) const {
    const int wale = forward(course) ? 0 : layout_.wales - 1;
    const Point p = loop_at(course, wale, -2 * heading(course));
    return {p.y, heading(course) * p.dy};
  }

  /// From where the yarn is to the start of a course, round in a half circle.
  void join(int course) {
    const Point to = start_of(course);
    const double reach = 2 * (to.y - end().y).norm();
    bridge(end(), to, reach, reach, at(course, forward(course) ? 0 : layout_.wales - 1).material);
  }

  /// A spiral in the strip, round the sinkers below `course` or the heads above it, from one x to another; `ahead` is
  /// how far the strip has gone on since it drew that course.
  void chain(int course, const ChainSize& size, double from, double to, double ahead) {
    const double wale = size_.wale(), first = centre_x(course, 0) + ahead;
    const std::vector<int> row = row_signs(course);
    const int last = layout_.wales - 1, turns = std::max(1, static_cast<int>(std::lround(std::abs(to - from) / wale)));
    const double width = (to - from) / turns;
    for (int k = 0; k < turns; ++k) {
      const double begin = from + k * width;
      const int middle = static_cast<int>(std::lround((begin + width / 2 - first) / wale));
      add(
          [=, loops = size_](double u) {
            const double x = begin + u * width;
            const int here = static_cast<int>(std::lround((x - first) / wale));
            const auto sign = [&](int i) { return row[static_cast<std::size_t>(std::clamp(i, 0, last))]; };
            const Curve3 c =
                chain_point(size, loops, sign(here - 1), sign(here), sign(here + 1), first + here * wale, x);
            return Point{c.y, width * c.dy};
          },
          edge_material(at(course, std::clamp(middle, 0, last)).material));
      pieces_.back().shrink = chain_shrink;
    }
  }

  /// The fabric's materials are followed by their edge forms, in the same order: see fit.
  int edge_material(int material) const { return material + materials_; }

  std::vector<int> row_signs(int course) const {
    std::vector<int> row;
    for (int wale = 0; wale < layout_.wales; ++wale) row.push_back(at(course, wale).sign);
    return row;
  }

  /// Against the first course, so that a U-turn leads into it.
  void cast_on() {
    const int h = heading(0);
    const double near = centre_x(0, forward(0) ? 0 : layout_.wales - 1);
    const double far = centre_x(0, forward(0) ? layout_.wales - 1 : 0);
    chain(0, {chain_, -size_.y, false}, far, near, 0);
    const Point start = start_of(0);
    const Point turn{start.y + Vec3(0, -1.7 * chain_, 0), Vec3(-h, 0, 0)};
    bridge(end(), turn, 2 * size_.x, 2 * size_.x, pieces_.back().material);
  }

  /// Back over the last course of a flat fabric; on in the round over that of a tube, which lies one course lower
  /// there.
  void bind_off() {
    const int last = layout_.courses - 1, h = heading(last), material = pieces_.back().material;
    const double near = centre_x(last, forward(last) ? layout_.wales - 1 : 0) + 2 * size_.x * h;
    const double row = level(last) + size_.y - (tube() ? size_.pitch : 0), round = h * layout_.wales * size_.wale();
    const std::size_t joint = pieces_.size();
    const Point from = end();
    if (tube())
      chain(last, {chain_, row, true}, near, near + round, round);
    else
      chain(last, {chain_, row, true}, near, near - round, 0);
    std::vector<CurvePiece> spiral(pieces_.begin() + static_cast<std::ptrdiff_t>(joint), pieces_.end());
    pieces_.resize(joint);
    const Point to = spiral.front().at(0);
    if (tube())
      rise(from, to, last);
    else
      bridge(from, to, 2 * size_.pitch, 2 * size_.pitch, material);
    pieces_.insert(pieces_.end(), spiral.begin(), spiral.end());
  }

  void rise(const Point& from, const Point& to, int course) {
    constexpr Rise by;
    const int first_wale = forward(course) ? 0 : layout_.wales - 1, last_wale = layout_.wales - 1 - first_wale;
    const PlacedLoop &leg_of = at(course, last_wale), &head_of = at(course, first_wale);
    const double aside = by.aside * (leg_of.sign - head_of.sign) / 2;
    const Point between{(from.y + to.y) / 2 + diameter_ * Vec3(by.ahead * heading(course), by.up, aside),
                        Vec3::UnitY()};
    bridge(from, between, by.leave * diameter_, by.middle * diameter_, leg_of.material);
    bridge(between, to, by.middle * diameter_, by.arrive * diameter_, leg_of.material);
  }

  const Layout& layout_;
  LoopSize size_;
  double diameter_, chain_;
  int materials_;
  std::vector<CurvePiece> pieces_;
};

double longest_stitch(const Layout& layout) {
  double longest = 0;
  for (const auto& row : layout.rows)
    for (const PlacedLoop& placed : row) longest = std::max(longest, placed.stitch_length);
  return longest;
}

}  // namespace

std::optional<Curves> thread(const Layout& layout, const Chart& chart, Diagnostics&) {
  double diameter = 0;
  for (const ChartYarn& yarn : chart.yarns) diameter = std::max(diameter, yarn.material.diameter);
  const LoopSize size = large_enough(diameter, longest_stitch(layout));

  const double round = size.wale() * layout.wales;
  const Strip strip{layout.form == Form::tube, round / (2 * std::numbers::pi),
                    (layout.from_left.front() ? 1 : -1) * size.pitch / round};
  YarnCurve yarn{Drawing(layout, size, diameter, static_cast<int>(chart.yarns.size())).draw()};
  if (strip.tube)
    for (CurvePiece& piece : yarn.pieces)
      piece.at = [strip, flat = std::move(piece.at)](double u) { return strip.wind(flat(u)); };
  return Curves{{std::move(yarn)}};
}

}  // namespace wale::passes
