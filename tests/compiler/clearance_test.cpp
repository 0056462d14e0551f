#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "sim/polyline.hpp"
#include "sim/tile.hpp"
#include "tests/support/structures.hpp"

namespace wale {
namespace {

constexpr int per_segment = 20;
constexpr double along = 1.6;  // diameters: nearer along the yarn is not looked at

Fabric compiled(const Chart& chart, int segments_per_stitch) {
  Diagnostics say;
  auto made = compile_chart(chart, segments_per_stitch, say);
  if (!made) throw std::runtime_error("the chart was refused");
  return std::move(made->fabric);
}

/// A place on a yarn; lengths in the diameter of the widest.
struct Place {
  Vec3 at = Vec3::Zero();
  int yarn = 0;
  double along = 0, diameter = 1;
};

std::vector<Place> places_on(const Fabric& fabric) {
  double widest = 0;
  for (const Material& yarn : fabric.materials) widest = std::max(widest, yarn.diameter);
  std::vector<Place> places;
  for (int i = 0; i < static_cast<int>(fabric.yarns.size()); ++i) {
    const Yarn& yarn = fabric.yarns[static_cast<std::size_t>(i)];
    const int last = yarn.first_segment + yarn.segments - 1;
    const Points p = polyline(fabric, fabric.points, yarn.first_segment, last, per_segment) / widest;
    double length = 0;
    for (Eigen::Index k = 0; k < p.cols(); ++k) {
      if (k > 0) length += (p.col(k) - p.col(k - 1)).norm();
      const int segment = std::min(yarn.first_segment + static_cast<int>(k) / per_segment, last);
      places.push_back({p.col(k), i, length, fabric.material_of(segment).diameter / widest});
    }
  }
  return places;
}

/// The least distance between two places of the yarns, in the diameter at which they touch; looks no farther than one.
double closest(const Fabric& fabric) {
  using Cell = std::array<int, 3>;
  std::map<Cell, std::vector<Place>> cells;
  double least = 1;
  for (const Place& place : places_on(fabric)) {
    const Cell here{static_cast<int>(std::floor(place.at.x())), static_cast<int>(std::floor(place.at.y())),
                    static_cast<int>(std::floor(place.at.z()))};
    for (int n = 0; n < 27; ++n) {
      const auto there = cells.find({here[0] + n % 3 - 1, here[1] + n / 3 % 3 - 1, here[2] + n / 9 - 1});
      if (there == cells.end()) continue;
      for (const Place& other : there->second)
        if (other.yarn != place.yarn || place.along - other.along > along)
          least = std::min(least, 2 * (place.at - other.at).norm() / (place.diameter + other.diameter));
    }
    cells[here].push_back(place);
  }
  return least;
}

/// With the twelve segments a stitch that scenes use by default; the spline cuts the corners of coarser ones.
TEST(Clearance, IsSevenTenthsOfADiameterEverywhere) {
  for (const auto& [name, chart] : all_structures()) EXPECT_GE(closest(compiled(chart, 12)), 0.7) << name;
}

TEST(Clearance, OfFlatFabricsIsFourFifthsOfADiameter) {
  for (const auto& structures : {basic_structures(6, 5, Form::flat), random_mixtures(20, Form::flat)})
    for (const auto& [name, chart] : structures) EXPECT_GE(closest(compiled(chart, 12)), 0.8) << name;
}

TEST(Clearance, OfAPeriodicFabricIsFourFifthsOfADiameterAtItsSeamsToo) {
  for (auto [name, chart] : basic_structures(4, 4, Form::flat)) {
    chart.periodic = true;
    const Fabric repeat = compiled(chart, 12);
    EXPECT_GE(closest(tile(repeat, points_and_periods(repeat), 2, 2)), 0.8) << name;
  }
}

/// Stripes of yarns of 0.3 and 0.6 mm, whatever the stitches.
TEST(Clearance, OfAChartInTwoDiametersIsFourFifthsOfThoseThatMeet) {
  for (auto [name, chart] : basic_structures(6, 6, Form::flat)) {
    chart.yarns = {{"thin", {.name = "thin", .diameter = 0.3e-3}}, {"thick", {.name = "thick", .diameter = 0.6e-3}}};
    for (std::size_t course = 0; course < chart.courses.size(); ++course)
      for (Cell& cell : chart.courses[course]) cell.yarn = static_cast<int>(course / 2 % 2);
    EXPECT_GE(closest(compiled(chart, 12)), 0.8) << name;
  }
}

/// `courses` rows of 6 needles on the front bed, or in rib; course by course with one of `carriers` in turn.
std::string program_of(bool rib, int courses, const std::vector<std::string>& carriers) {
  std::string text = ";!knitout-2\n;;Carriers: 1 2\n;;Machine: Kniterate\nin 1\nin 2\n";
  for (int course = 0; course < courses; ++course)
    for (int k = 0; k < 6; ++k) {
      const int needle = course % 2 ? 5 - k : k;
      text += fmt::format("knit {} {}{} {}\n", course % 2 ? '-' : '+', rib && needle % 2 ? 'b' : 'f', needle,
                          carriers[static_cast<std::size_t>(course) % carriers.size()]);
    }
  return text;
}

double closest_knitted(const std::string& program, double first, double second) {
  const Source source{"program.k", program};
  YarnMaterials yarns;
  yarns.by_name = {{"1", {.name = "one", .diameter = first}, {}}, {"2", {.name = "two", .diameter = second}, {}}};
  KnitoutOptions options;
  options.stitch_lengths.otherwise = 9e-3;
  Diagnostics say;
  const auto made = compile_knitout(source, options, yarns, 12, say);
  if (!made) throw std::runtime_error("the program was refused");
  return closest(made->fabric);
}

/// Drawn for the thicker of two yarns, so that the thinner has no less room than it would have among its like.
TEST(Clearance, OfAProgramInTwoDiametersIsNoLessThanInTheThickerAlone) {
  const std::vector<std::vector<std::string>> all{{"1", "1", "2", "2"}, {"1 2"}, {"2 1"}};
  for (const auto& carriers : all)
    for (const bool rib : {false, true}) {
      SCOPED_TRACE(carriers.front() + (rib ? " in rib" : " in jersey"));
      const std::string program = program_of(rib, 6, carriers);
      const double alone = closest_knitted(program, 0.6e-3, 0.6e-3);
      for (const double mixed : {closest_knitted(program, 0.3e-3, 0.6e-3), closest_knitted(program, 0.6e-3, 0.3e-3)}) {
        EXPECT_GE(mixed, 0.99 * alone);
        EXPECT_GE(mixed, 0.6);
      }
    }
}

TEST(Clearance, GrowsWithTheStitchWhereAFabricIsLoose) {
  Chart chart = make_random_chart(5, 5, Form::flat, 3);
  for (auto& course : chart.courses)
    for (Cell& cell : course) cell.stitch_length = 15e-3;
  EXPECT_GE(closest(compiled(chart, 12)), 0.8);
}

}  // namespace
}  // namespace wale
