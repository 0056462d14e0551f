/// Where yarn goes between stitches that do not lie side by side.
#pragma once

#include <vector>

#include "compiler/arrangement.hpp"
#include "compiler/curves.hpp"
#include "compiler/passes/loop_shape.hpp"

namespace wale {

class Floats {
 public:
  /// The arrangement must outlive it; `diameter` is that of the thickest yarn, m.
  Floats(const Arrangement& arrangement, const LoopSize& size, double diameter)
      : arrangement_(arrangement), size_(size), diameter_(diameter) {}

  /// The points that a step's yarn passes on its way, none if it may go straight. A tube's strip passes every place
  /// once a round: nearest to `x`.
  std::vector<Vec3> way(const YarnStep&, const CurvePiece::Point& from, const CurvePiece::Point& to, double x) const;

 private:
  using Point = CurvePiece::Point;
  int sign(int loop) const { return arrangement_.loops[static_cast<std::size_t>(loop)].sign; }
  Vec3 middle_of(int loop, double x) const;
  std::vector<Vec3> led_by_misses(const std::vector<Leg>&, const Vec3& from, const Vec3& to, double x) const;
  bool goes_on_from_row_to_row(const std::vector<Vec3>& way, const Vec3& from, const Vec3& to) const;
  std::vector<Vec3> round_the_side(const Point& from, const Point& to) const;
  std::vector<Vec3> up_the_inside(const Point& from, const Point& to) const;
  std::vector<Vec3> passed(const std::vector<int>& loops, const Vec3& from, const Vec3& to, double x) const;

  const Arrangement& arrangement_;
  LoopSize size_;
  double diameter_;
};

}  // namespace wale
