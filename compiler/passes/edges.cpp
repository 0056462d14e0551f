#include "compiler/passes/edges.hpp"

#include <algorithm>
#include <cmath>

#include "compiler/passes/chain_shape.hpp"
#include "compiler/passes/hermite.hpp"

namespace wale {
namespace {

using Point = CurvePiece::Point;

constexpr double chain_radius = 1.3;  // of the spirals, in diameters
// Beyond what the stitches shrink: joins are drawn in wide half circles and knitted straight, and a chain pulled tight
// keeps the heads that it holds from turning over.
constexpr double join_shrink = 0.7;
constexpr double chain_shrink = 0.9;
constexpr double u_turn = 1.7;  // depth of the turn into the first course, in chain radii

/// How a tube's yarn rises from the foot of its last loop into the bind-off, between that loop and the next one; found
/// by search for the most room. In diameters.
struct Rise {
  double ahead = 0.26, up = -1.19;  ///< of the middle between foot and spiral
  double aside = 0.4;               ///< away from the leg and the head on either side, if these lie on one side
  double leave = 2.3, middle = 4.05, arrive = 0.5;  ///< lengths of the tangents
};

class Edging {
 public:
  Edging(const EdgeRow& row, const EdgeStyle& style)
      : row_(row), style_(style), radius_(chain_radius * style.diameter) {}

  std::vector<CurvePiece> cast_on() {
    const int h = row_.heading;
    chain({radius_, row_.level - style_.size.y, false}, last_x(), first_x(), 0);
    const Point start = style_.stitch;
    const Point turn{start.y + Vec3(0, -u_turn * radius_, 0), Vec3(-h, 0, 0)};
    const double reach = 2 * style_.size.x;
    bridge(pieces_.back().at(1), turn, reach, reach, pieces_.back().material);
    const double round = 2 * (start.y - turn.y).norm();
    bridge(turn, start, round, round, first_place().material);
    return std::move(pieces_);
  }

  std::vector<CurvePiece> bind_off_flat() {
    const double near = beyond_last();
    chain({radius_, row_.level + style_.size.y, true}, near, near - length(), 0);
    const double reach = 2 * style_.size.pitch;
    const Point to = pieces_.front().at(0);
    lead_in([&] { bridge(style_.stitch, to, reach, reach, last_place().material); });
    return std::move(pieces_);
  }

  std::vector<CurvePiece> bind_off_round() {
    const double near = beyond_last();
    chain({radius_, row_.level + style_.size.y - style_.size.pitch, true}, near, near + length(), length());
    const Point to = pieces_.front().at(0);
    lead_in([&] { rise(style_.stitch, to); });
    return std::move(pieces_);
  }

 private:
  double wale() const { return style_.size.wale(); }
  double length() const { return row_.heading * wale() * (row_.last() + 1); }
  double x_of(int i) const { return row_.first + i * wale(); }
  double first_x() const { return x_of(row_.heading > 0 ? 0 : row_.last()); }
  double last_x() const { return x_of(row_.heading > 0 ? row_.last() : 0); }
  double beyond_last() const { return last_x() + 2 * style_.size.x * row_.heading; }
  const EdgeRow::Place& first_place() const { return row_.heading > 0 ? row_.wales.front() : row_.wales.back(); }
  const EdgeRow::Place& last_place() const { return row_.heading > 0 ? row_.wales.back() : row_.wales.front(); }

  void add(std::function<Point(double)> at, int material, double shrink) {
    pieces_.push_back({std::move(at), -1, material, 0, shrink});
  }

  /// A cubic between two directions; the longer the reach, the wider it swings out.
  void bridge(const Point& from, const Point& to, double reach_from, double reach_to, int material) {
    const Point a{from.y, reach_from * from.dy.normalized()}, b{to.y, reach_to * to.dy.normalized()};
    add([a, b](double u) { return hermite(a, b, u); }, material, join_shrink);
  }

  /// Puts what `lead` adds before the chain.
  template <class Lead>
  void lead_in(const Lead& lead) {
    std::vector<CurvePiece> spiral = std::move(pieces_);
    pieces_.clear();
    lead();
    std::move(spiral.begin(), spiral.end(), std::back_inserter(pieces_));
  }

  /// A spiral in the strip, round the row's sinkers or heads, from one x to another; `ahead` is how far the strip has
  /// gone on since it drew that row.
  void chain(const ChainSize& size, double from, double to, double ahead) {
    std::vector<int> signs;
    for (const EdgeRow::Place& place : row_.wales) signs.push_back(place.sign);
    const double first = row_.first + ahead;
    const int last = row_.last(), turns = std::max(1, static_cast<int>(std::lround(std::abs(to - from) / wale())));
    const double width = (to - from) / turns;
    for (int k = 0; k < turns; ++k) {
      const double begin = from + k * width;
      const int middle = std::clamp(static_cast<int>(std::lround((begin + width / 2 - first) / wale())), 0, last);
      add(
          [=, loops = style_.size](double u) {
            const double x = begin + u * width;
            const int here = static_cast<int>(std::lround((x - first) / loops.wale()));
            const auto sign = [&](int i) { return signs[static_cast<std::size_t>(std::clamp(i, 0, last))]; };
            const Curve3 c =
                chain_point(size, loops, sign(here - 1), sign(here), sign(here + 1), first + here * loops.wale(), x);
            return Point{c.y, width * c.dy};
          },
          row_.wales[static_cast<std::size_t>(middle)].material + style_.yarns, chain_shrink);
    }
  }

  void rise(const Point& from, const Point& to) {
    constexpr Rise by;
    const double d = style_.diameter, aside = by.aside * (last_place().sign - first_place().sign) / 2;
    const Point between{(from.y + to.y) / 2 + d * Vec3(by.ahead * row_.heading, by.up, aside), Vec3::UnitY()};
    bridge(from, between, by.leave * d, by.middle * d, last_place().material);
    bridge(between, to, by.middle * d, by.arrive * d, last_place().material);
  }

  const EdgeRow& row_;
  const EdgeStyle& style_;
  double radius_;
  std::vector<CurvePiece> pieces_;
};

}  // namespace

std::vector<CurvePiece> cast_on(const EdgeRow& first, const EdgeStyle& style) { return Edging(first, style).cast_on(); }

std::vector<CurvePiece> bind_off_flat(const EdgeRow& last, const EdgeStyle& style) {
  return Edging(last, style).bind_off_flat();
}

std::vector<CurvePiece> bind_off_round(const EdgeRow& last, const EdgeStyle& style) {
  return Edging(last, style).bind_off_round();
}

}  // namespace wale
