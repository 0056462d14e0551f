#include "sim/results/picture.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "sim/results/svg.hpp"
#include "sim/spline.hpp"
#include "tests/sim/results/made_results.hpp"

namespace wale {
namespace {

/// Two straight yarns of 20 segments, 5 mm long, along x and along y, that cross at the origin at heights ±`height`.
Fabric cross(double height) {
  Fabric fabric;
  fabric.materials = {{.name = "along x"}, {.name = "along y"}};
  fabric.points.resize(3, 46);
  for (int yarn = 0; yarn < 2; ++yarn) {
    fabric.yarns.push_back({23 * yarn, 20 * yarn, 20});
    for (int i = 0; i < 20; ++i) fabric.segments.push_back({yarn, yarn, -1, 0.25e-3, 0.2e-3});
    for (int i = 0; i < 23; ++i) {
      const double along = 0.25e-3 * (i - 11);
      fabric.points.col(23 * yarn + i) = yarn == 0 ? Vec3(along, 0, height) : Vec3(0, along, -height);
    }
  }
  return fabric;
}

/// What stands between `before` and the next quotation mark, from `at` on.
std::string attribute(const std::string& svg, const std::string& before, std::size_t at) {
  const std::size_t from = svg.find(before, at) + before.size();
  return svg.substr(from, svg.find('"', from) - from);
}

/// The colour of the last stroke that covers a place, px: what a viewer of the picture sees there.
std::string seen(const std::string& svg, double x, double y) {
  std::string colour = "none";
  const std::string path = "<path stroke=\"#";
  const std::size_t yarns_end = svg.find("</g>");
  for (std::size_t at = svg.find(path); at < yarns_end; at = svg.find(path, at + 1)) {
    const double half = std::stod(attribute(svg, "stroke-width=\"", at)) / 2;
    std::string d = attribute(svg, " d=\"", at), spaced;
    for (const char c : d) spaced += c == 'M' || c == 'L' ? std::string(" ") + c + " " : std::string(1, c);
    std::istringstream words(spaced);
    std::string letter;
    double px = 0, py = 0;
    for (double qx = 0, qy = 0; words >> letter >> qx >> qy; px = qx, py = qy) {
      if (letter == "M") continue;
      const double length2 = (qx - px) * (qx - px) + (qy - py) * (qy - py);
      const double s = ((x - px) * (qx - px) + (y - py) * (qy - py)) / length2;
      const bool covers = s >= 0 && s <= 1 && std::hypot(px + s * (qx - px) - x, py + s * (qy - py) - y) <= half;
      if (covers) colour = attribute(svg, "stroke=\"", at);
    }
  }
  return colour;
}

/// Where the yarns cross in the picture, px: the middle of the fabric, off the light line along each yarn.
constexpr double middle_x = 24 + 450 + 30, middle_y = 44 + 450 + 30;

TEST(FabricPicture, ShowsTheNearerYarnOverTheOther) {
  const Fabric above = cross(0.262e-3), below = cross(-0.262e-3);
  EXPECT_EQ(seen(fabric_svg(above, above.points, {}), middle_x, middle_y), svg::hex(svg::palette(0)));
  EXPECT_EQ(seen(fabric_svg(below, below.points, {}), middle_x, middle_y), svg::hex(svg::palette(1)));
  EXPECT_EQ(seen(fabric_svg(above, above.points, {}), middle_x + 200, middle_y + 200), "none");
}

TEST(FabricPicture, DrawsNoOutlineAcrossAYarnAndNoGap) {
  const testing::MadeJersey made = testing::made_jersey(1, 1);
  const std::string svg = fabric_svg(made.fabric, made.fabric.points, {.size = 400});
  const Fabric& fabric = made.fabric;
  double left = 1, right = -1, top = -1, bottom = 1;
  for (int i = 0; i < fabric.segment_count(); ++i)
    for (const double s : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Vec3 y = combine(fabric.points, fabric.first_point(i), basis(s).value);
      left = std::min(left, y.x()), right = std::max(right, y.x()), top = std::max(top, y.y()),
      bottom = std::min(bottom, y.y());
    }
  const double d = made.diameter, scale = 400 / (std::max(right - left, top - bottom) + d);
  for (int i = 0; i < fabric.segment_count(); ++i)
    for (const double s : {0.01, 0.3, 0.6, 0.99}) {
      const Vec3 y = combine(fabric.points, fabric.first_point(i), basis(s).value);
      const Vec3 along = combine(fabric.points, fabric.first_point(i), basis(s).first);
      const Vec3 aside = Vec3(-along.y(), along.x(), 0).normalized() * 0.3 * d;
      for (const double side : {-1.0, 1.0}) {
        const double px = 24 + scale * (y.x() + side * aside.x() - left + d / 2);
        const double py = 44 + scale * (top - y.y() - side * aside.y() + d / 2);
        ASSERT_EQ(seen(svg, px, py), svg::hex(svg::palette(0))) << i << " " << s << " " << side;
      }
    }
}

TEST(FabricPicture, ColoursByStrainWithItsScale) {
  const Fabric fabric = cross(0.262e-3);
  PictureOptions options{.title = "a < b", .colour_by = ColourBy::stretch, .strains = std::array<double, 2>{0, 0.5}};
  const std::string svg = fabric_svg(fabric, fabric.points, options);
  // Rest lengths are 0.2 mm for 0.25 mm of yarn: 25 %, the middle of the scale.
  EXPECT_EQ(seen(svg, middle_x, middle_y), svg::hex(svg::gradient(20.0 / 39)));
  EXPECT_NE(svg.find("yarn strain, %"), std::string::npos);
  EXPECT_NE(svg.find(">20</text>"), std::string::npos);
  EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
  EXPECT_NE(svg.find(">1 mm</text>"), std::string::npos);
  options.rest = 0;  // now unstretched
  EXPECT_EQ(seen(fabric_svg(fabric, fabric.points, options), middle_x, middle_y), svg::hex(svg::gradient(0)));
}

TEST(FabricPicture, OfASwatchIsUnderTwoMegabytes) {
  const testing::MadeJersey made = testing::made_jersey(12, 13, 24);
  EXPECT_LT(fabric_svg(made.fabric, made.fabric.points, {.colour_by = ColourBy::stretch}).size(), 2e6);
}

TEST(CurvePicture, PutsEveryPointWhereTheAxesSay) {
  Curve curve;
  curve.strain = {0, 0.25, 0.5};
  curve.stress = {0, 0.5e6, 2e6};
  const std::string svg = curve_svg({{"jersey & rib", curve}}, "Title");
  // 760 x 480 px, axes from (84, 418) to (736, 44), stress to 1.05 of the greatest.
  EXPECT_NE(svg.find(fmt::format("points=\"84.0,418.0 410.0,{:.1f} 736.0,{:.1f} \"", 418 - 374 * 0.5 / 2.1,
                                 418 - 374 * 2 / 2.1)),
            std::string::npos);
  for (const char* words : {"strain, %", "stress, MPa", "jersey &amp; rib", ">Title<", ">50<", ">1.5<"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
}

TEST(CurvePicture, OfNothingIsItsAxes) { EXPECT_NE(curve_svg({}).find("strain, %"), std::string::npos); }

TEST(TerminalPlot, IsSixtyByFifteenAndRisesToTheCorner) {
  std::istringstream lines(terminal_plot(stress_strain(testing::made_results())));
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  ASSERT_EQ(all.size(), 18U);
  for (int row = 1; row <= 15; ++row) EXPECT_EQ(all[row].size(), 10 + 1 + 3 + 3 * 60U) << row;
  EXPECT_NE(all[1].substr(all[1].size() - 3), "⠀");
  EXPECT_NE(all[15].substr(14, 3), "⠀");
  EXPECT_EQ(all[1].substr(14, 3), "⠀");
  EXPECT_EQ(all[15].substr(all[15].size() - 3), "⠀");
  EXPECT_NE(all[17].find("60 %"), std::string::npos);
  EXPECT_EQ(terminal_plot({}), "no curve\n");
}

TEST(Svg, TicksAreRoundAndNotTooMany) {
  EXPECT_EQ(svg::ticks(0, 60, 8), (std::vector<double>{0, 10, 20, 30, 40, 50, 60}));
  EXPECT_EQ(svg::ticks(0, 1, 5).size(), 6U);
  EXPECT_EQ(svg::ticks(-3, 3, 4).size(), 3U);
  EXPECT_TRUE(svg::ticks(1, 1, 5).empty());
  for (double high = 1e-6; high < 1e6; high *= 1.37) {
    EXPECT_LE(svg::ticks(0, high, 8).size(), 9U) << high;
    EXPECT_GE(svg::ticks(0, high, 8).size(), 3U) << high;
  }
}

}  // namespace
}  // namespace wale
