#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "compiler/compile.hpp"
#include "sim/polyline.hpp"
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

/// The least distance between two places of the yarn, in diameters; looks no farther than one diameter.
double closest(const Fabric& fabric) {
  const double d = fabric.materials.front().diameter;
  const Points p = polyline(fabric, fabric.points, 0, fabric.segment_count() - 1, per_segment) / d;
  std::vector<double> at{0};
  for (Eigen::Index k = 1; k < p.cols(); ++k) at.push_back(at.back() + (p.col(k) - p.col(k - 1)).norm());

  using Cell = std::array<int, 3>;
  const auto cell_of = [&](Eigen::Index k) {
    return Cell{static_cast<int>(std::floor(p(0, k))), static_cast<int>(std::floor(p(1, k))),
                static_cast<int>(std::floor(p(2, k)))};
  };
  std::map<Cell, std::vector<Eigen::Index>> cells;
  double least = 1;
  for (Eigen::Index k = 0; k < p.cols(); ++k) {
    const Cell here = cell_of(k);
    for (int n = 0; n < 27; ++n) {
      const auto there = cells.find({here[0] + n % 3 - 1, here[1] + n / 3 % 3 - 1, here[2] + n / 9 - 1});
      if (there == cells.end()) continue;
      for (const Eigen::Index other : there->second)
        if (at[static_cast<std::size_t>(k)] - at[static_cast<std::size_t>(other)] > along)
          least = std::min(least, (p.col(k) - p.col(other)).norm());
    }
    cells[here].push_back(k);
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

TEST(Clearance, GrowsWithTheStitchWhereAFabricIsLoose) {
  Chart chart = make_random_chart(5, 5, Form::flat, 3);
  for (auto& course : chart.courses)
    for (Cell& cell : course) cell.stitch_length = 15e-3;
  EXPECT_GE(closest(compiled(chart, 12)), 0.8);
}

}  // namespace
}  // namespace wale
