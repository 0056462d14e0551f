#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "compiler/passes.hpp"
#include "compiler/passes/interpolate.hpp"
#include "sim/spline.hpp"
#include "tests/support/make_chart.hpp"

namespace wale {
namespace {

constexpr int segments_per_stitch = 12;

struct Fitted {
  StitchGraph graph;
  Curves curves;
  Fabric fabric;
};

Fitted fitted(const Chart& chart) {
  Diagnostics say;
  const auto program = passes::lower_chart(chart, say);
  auto graph = program ? passes::knit(*program, say) : std::nullopt;
  if (!graph) throw std::runtime_error("the chart was refused");
  const double d = chart.yarns.front().material.diameter;
  const LoopSize size = large_enough(d, longest_stitch(*graph));
  Curves curves = passes::draw(*graph, passes::arrange(*graph, size, d), size, d,
                               {true, true, static_cast<int>(chart.yarns.size())});
  Fabric fabric = passes::fit(curves, chart.materials(), segments_per_stitch);
  return {std::move(*graph), std::move(curves), std::move(fabric)};
}

Chart mixture(Form form) { return make_random_chart(8, 4, form, 7); }

/// Arc length by Simpson's rule on a dense table, and its inverse by bisection.
class DenseArc {
 public:
  explicit DenseArc(const YarnCurve& curve) : curve_(curve) {
    for (const CurvePiece& piece : curve.pieces)
      for (int k = 0; k < steps; ++k)
        at_.push_back(at_.back() + simpson(piece, k / double(steps), (k + 1) / double(steps)));
  }
  double total() const { return at_.back(); }
  Vec3 point(double s) const {
    const auto after = std::upper_bound(at_.begin() + 1, at_.end() - 1, s) - 1;
    const auto cell = static_cast<int>(after - at_.begin());
    const CurvePiece& piece = curve_.pieces[static_cast<std::size_t>(cell / steps)];
    const double from = cell % steps / double(steps);
    double low = from, high = from + 1.0 / steps;
    for (int k = 0; k < 50; ++k) {
      const double middle = (low + high) / 2;
      (*after + simpson(piece, from, middle) < s ? low : high) = middle;
    }
    return piece.at(low).y;
  }

 private:
  static constexpr int steps = 1500;
  static double simpson(const CurvePiece& piece, double a, double b) {
    return (b - a) / 6 * (piece.at(a).dy.norm() + 4 * piece.at((a + b) / 2).dy.norm() + piece.at(b).dy.norm());
  }

  const YarnCurve& curve_;
  std::vector<double> at_{0};
};

TEST(Interpolate, GoesThroughItsPointsWithTheGivenEnds) {
  const Points through = Points::Random(3, 9);
  const Vec3 from(0.3, -2, 1), to(5, 0.1, 0);
  const Points q = interpolate(through, from, to);
  ASSERT_EQ(q.cols(), 11);
  for (int k = 0; k < 8; ++k) EXPECT_NEAR((combine(q, k, basis(0).value) - through.col(k)).norm(), 0, 1e-14);
  EXPECT_NEAR((combine(q, 7, basis(1).value) - through.col(8)).norm(), 0, 1e-14);
  EXPECT_NEAR((combine(q, 0, basis(0).first) - from).norm(), 0, 1e-14);
  EXPECT_NEAR((combine(q, 7, basis(1).first) - to).norm(), 0, 1e-14);
}

TEST(Interpolate, GivesACubicBackExactly) {
  const auto cubic = [](double s) { return Vec3(s * s * s - s, 2 - s * s, 0.5 * s * s * s); };
  const auto slope = [](double s) { return Vec3(3 * s * s - 1, -2 * s, 1.5 * s * s); };
  Points through(3, 6);
  for (int k = 0; k < 6; ++k) through.col(k) = cubic(k);
  const Points q = interpolate(through, slope(0), slope(5));
  for (double s = 0.05; s < 5; s += 0.1) {
    const int k = static_cast<int>(s);
    EXPECT_NEAR((combine(q, k, basis(s - k).value) - cubic(s)).norm(), 0, 1e-11);
  }
}

TEST(Interpolate, WithoutEndGoesThroughItsPointsAgainAfterEveryPeriod) {
  for (const int n : {1, 2, 7, 40}) {
    const Points through = Points::Random(3, n);
    const Vec3 period(3, 0.2, -1);
    const Points q = interpolate_periodic(through, period);
    ASSERT_EQ(q.cols(), n + 3);
    for (int k = 0; k < n; ++k) EXPECT_NEAR((combine(q, k, basis(0).value) - through.col(k)).norm(), 0, 1e-13) << n;
    EXPECT_NEAR((combine(q, n - 1, basis(1).value) - through.col(0) - period).norm(), 0, 1e-13) << n;
    for (int k = 0; k < 3; ++k) EXPECT_EQ(Vec3(q.col(n + k)), Vec3(q.col(k) + period)) << n;
  }
}

TEST(Fit, CutsTheExactCurveIntoEqualArcLengths) {
  for (const Form form : {Form::flat, Form::tube}) {
    const Fitted made = fitted(mixture(form));
    const Yarn& yarn = made.fabric.yarns.front();
    const DenseArc arc(made.curves.yarns.front());
    for (int k = 0; k <= yarn.segments; ++k) {
      const int segment = std::min(k, yarn.segments - 1);
      const Vec3 joint = combine(made.fabric.points, segment, basis(k - segment).value);
      const Vec3 wanted = arc.point(arc.total() * k / yarn.segments);
      ASSERT_NEAR((joint - wanted).norm(), 0, 1e-9 * arc.total()) << k;
    }
  }
}

TEST(Fit, RestLengthsAreEqualAndAddUpToTheCurve) {
  const Fitted made = fitted(mixture(Form::flat));
  const DenseArc arc(made.curves.yarns.front());
  double total = 0;
  for (const Segment& segment : made.fabric.segments) {
    EXPECT_DOUBLE_EQ(segment.length, made.fabric.segments.front().length);
    total += segment.length;
  }
  EXPECT_NEAR(total, arc.total(), 1e-9 * arc.total());
}

TEST(Fit, EndsPointAlongTheCurveAtUnitStretch) {
  for (const Form form : {Form::flat, Form::tube}) {
    const Fitted made = fitted(mixture(form));
    const auto& pieces = made.curves.yarns.front().pieces;
    const double length = made.fabric.segments.front().length;
    const Vec3 from = combine(made.fabric.points, 0, basis(0).first) / length;
    const Vec3 to = combine(made.fabric.points, made.fabric.segment_count() - 1, basis(1).first) / length;
    EXPECT_NEAR((from - pieces.front().at(0).dy.normalized()).norm(), 0, 1e-9);
    EXPECT_NEAR((to - pieces.back().at(1).dy.normalized()).norm(), 0, 1e-9);
  }
}

TEST(Draw, PiecesFollowEachOtherInPositionAndDirection) {
  for (const Form form : {Form::flat, Form::tube}) {
    const Fitted made = fitted(mixture(form));
    const auto& pieces = made.curves.yarns.front().pieces;
    for (std::size_t k = 1; k < pieces.size(); ++k) {
      const auto a = pieces[k - 1].at(1), b = pieces[k].at(0);
      EXPECT_NEAR((a.y - b.y).norm(), 0, 1e-15) << k;
      EXPECT_NEAR((a.dy.normalized() - b.dy.normalized()).norm(), 0, 1e-9) << k;
    }
  }
}

TEST(Fit, KnitsEachStitchToItsLengthButForOneSegment) {
  Chart chart = mixture(Form::flat);
  for (std::size_t course = 0; course < chart.courses.size(); ++course)
    for (Cell& cell : chart.courses[course]) cell.stitch_length = course < 2 ? 7.23e-3 : 8.4e-3;
  const Fitted made = fitted(chart);
  std::map<int, double> knitted, longest;
  for (const Segment& segment : made.fabric.segments) {
    knitted[segment.stitch] += segment.knitted;
    longest[segment.stitch] = std::max(longest[segment.stitch], segment.knitted);
  }
  double sum = 0, wanted = 0;
  for (int i = 0; i < static_cast<int>(made.graph.loops.size()); ++i) {
    const Loop& loop = made.graph.loops[static_cast<std::size_t>(i)];
    EXPECT_NEAR(knitted.at(i), loop.cell.course < 2 ? 7.23e-3 : 8.4e-3, longest.at(i));
    sum += knitted.at(i);
    wanted += loop.stitch_length;
  }
  EXPECT_NEAR(sum, wanted, 0.01 * wanted);
}

TEST(Fit, SegmentsOnlyShrink) {
  for (const double stitch_length : {5e-3, 7.23e-3, 12e-3}) {
    Chart chart = mixture(Form::flat);
    for (auto& course : chart.courses)
      for (Cell& cell : course) cell.stitch_length = stitch_length;
    for (const Segment& segment : fitted(chart).fabric.segments) {
      EXPECT_GT(segment.knitted, 0);
      EXPECT_LE(segment.knitted, segment.length);
    }
  }
}

TEST(Fit, SegmentsCarryMaterialAndStitch) {
  Chart chart = mixture(Form::flat);
  chart.yarns.push_back({"b", Material{.name = "thin", .diameter = 0.4e-3}, "#000000"});
  const Fitted made = fitted(chart);
  std::map<int, int> count;
  int before = -1;
  for (const Segment& segment : made.fabric.segments) {
    ++count[segment.stitch];
    EXPECT_EQ(made.fabric.materials[static_cast<std::size_t>(segment.material)].name.rfind(Material{}.name, 0), 0U);
    if (segment.stitch >= 0) {
      EXPECT_EQ(segment.material, 0);
      EXPECT_GE(segment.stitch, before);
      before = segment.stitch;
    }
  }
  EXPECT_EQ(made.fabric.materials.size(), 2u) << "of the thin yarn there is nothing; the other one has its edge form";
  for (int i = 0; i < static_cast<int>(made.graph.loops.size()); ++i)
    EXPECT_NEAR(count.at(i), segments_per_stitch, 2) << i;
}

}  // namespace
}  // namespace wale
