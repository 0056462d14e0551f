#include <algorithm>
#include <cmath>

#include "tests/stability/hard_case.hpp"
#include "tests/stability/laid_yarns.hpp"

namespace wale::stability {
namespace {

const Vec3 x = Vec3::UnitX();
constexpr double mm = 1e-3;
constexpr double pull_time = 2e-3;  // s

HardScene tightened(Fabric fabric, std::vector<Tether> ends) {
  HardScene hard;
  hard.scene.fabric = std::move(fabric);
  Stage stage;
  stage.duration = pull_time;
  stage.samples = 20;
  stage.effects = {Stretch{}, Bend{}, Contact{}, Drag{}};
  for (Tether& end : ends) {
    end.progress = Schedule::ramp(0, 1, pull_time);
    stage.effects.emplace_back(std::move(end));
  }
  hard.scene.stages = {std::move(stage)};
  return hard;
}

/// Shastri's trefoil (t³ - 3 t, t⁴ - 4 t², t⁵ - 10 t), its ends led away flat; `hand` is 1 or -1.
std::vector<Vec3> overhand(double hand) {
  std::vector<Vec3> line{{-10 * mm, 4 * mm, 0}};
  for (double t = -2.3; t < 2.31; t += 0.1) {
    const double depth = std::clamp(std::pow(t, 5) - 10 * t, -8.0, 8.0);
    line.emplace_back(0.8 * mm * (t * t * t - 3 * t), 0.5 * mm * (std::pow(t, 4) - 4 * t * t), hand * 0.3 * mm * depth);
  }
  line.emplace_back(10 * mm, 4 * mm, 0);
  return line;
}

/// Its ends are moved apart by so many millimetres.
HardScene overhand_knot(double way) {
  Fabric fabric = fabric_of();
  lay(fabric, overhand(1));
  std::vector<Tether> ends{{.label = "left", .segments = start_of(fabric, 0), .move = -way / 2 * mm * x},
                           {.label = "right", .segments = end_of(fabric, 0), .move = way / 2 * mm * x}};
  HardScene hard = tightened(std::move(fabric), std::move(ends));
  hard.tied = true;
  return hard;
}

/// Two bights, one of which comes up through the other, round behind its legs and down through it again.
HardScene square_knot(double way) {
  Fabric fabric = fabric_of();
  const double a = 1.6 * mm, b = 0.6 * mm, h = 0.95 * mm;
  lay(fabric, {{-10 * mm, a, 0},
               {-2 * mm, a, 0},
               {0, a, 0},
               {1.6 * mm, a, 0},
               {1.6 * mm, -a, 0},
               {0, -a, 0},
               {-2 * mm, -a, 0},
               {-10 * mm, -a, 0}});
  const std::vector<Vec3> half{{10 * mm, b, 0},         {3 * mm, b, -h},   {1.2 * mm, b, -h},
                               {0, 0.8 * mm, 0.2 * mm}, {-0.8 * mm, a, h}, {-1.6 * mm, a + 0.8 * mm, 0},
                               {-2.4 * mm, a, -h}};
  std::vector<Vec3> whole = half;
  for (auto point = half.rbegin(); point != half.rend(); ++point) whole.push_back(point->cwiseProduct(Vec3(1, -1, 1)));
  lay(fabric, whole);
  std::vector<Tether> ends{{.label = "left", .segments = ends_of(fabric, 0), .move = -way / 2 * mm * x},
                           {.label = "right", .segments = ends_of(fabric, 1), .move = way / 2 * mm * x}};
  HardScene hard = tightened(std::move(fabric), std::move(ends));
  hard.closings = {{0, round_by(-x, Vec3::UnitY(), -x)}, {1, round_by(x, Vec3::UnitY(), x)}};
  return hard;
}

}  // namespace

std::vector<HardCase> cases_of_knots() {
  return {
      {"overhand knot tightened", "mm", {10}, {5, 10, 15, 20, 25, 30}, overhand_knot},
      {"square knot tightened", "mm", {4}, {2, 4, 6, 8, 10, 12, 16}, square_knot},
  };
}

}  // namespace wale::stability
