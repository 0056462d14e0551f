#include "tests/stability/passing_through.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "sim/polyline.hpp"
#include "sim/tile.hpp"
#include "tests/stability/linking.hpp"
#include "tests/support/projected_crossings.hpp"

namespace wale::stability {
namespace {

constexpr int per_segment = 4;  // chords
constexpr int repeats_up = 3;

Points yarn_of(const Fabric& fabric, const Points& q, int yarn, int chords) {
  const Yarn& of = fabric.yarns[static_cast<std::size_t>(yarn)];
  return polyline(fabric, q, of.first_segment, of.first_segment + of.segments - 1, chords);
}

std::vector<Points> closed_curves(const HardScene& hard, const Fabric& fabric, const Points& q) {
  if (fabric.cell) return bent_round(fabric, q, repeats_up);
  std::vector<Points> curves;
  for (const Closing& closing : hard.closings) {
    const Points line = yarn_of(fabric, q, closing.yarn, per_segment);
    Points closed(3, line.cols() + closing.by.cols());
    closed << line, closing.by;
    curves.push_back(std::move(closed));
  }
  return curves;
}

/// Of every pair, in order.
std::vector<long> linking_numbers(const std::vector<Points>& curves) {
  std::vector<long> numbers;
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (std::size_t j = i + 1; j < curves.size(); ++j)
      numbers.push_back(std::lround(linking_number(curves[i], curves[j])));
  return numbers;
}

}  // namespace

std::vector<Points> bent_round(const Fabric& periodic, const Points& q, int up) {
  const Fabric tiled = tile(periodic, q, 1, up);
  const double radius = q.col(q.cols() - 2).norm() / (2 * std::numbers::pi);
  std::vector<Points> curves;
  for (int yarn = 0; yarn < static_cast<int>(tiled.yarns.size()); ++yarn) {
    const Points line = yarn_of(tiled, tiled.points, yarn, 2 * per_segment);
    Points curve = line.leftCols(line.cols() - 1);  // its end is its start, a period on
    for (auto p : curve.colwise()) {
      const double angle = p.x() / radius, scale = std::exp(p.y() / radius);
      p = scale * Vec3(radius * std::cos(angle), radius * std::sin(angle), p.z());
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

long knot_determinant(const Fabric& fabric, const Points& q) {
  const auto seen = projected_crossings(drawn_from_the_face(fabric, q, false));
  const auto count = static_cast<Eigen::Index>(seen.size());
  std::vector<double> under;  // where the yarn dives: its arcs go from one such place to the next
  for (const SeenCrossing& at : seen) under.push_back(at.above > 0 ? at.second : at.first);
  std::sort(under.begin(), under.end());
  const auto arc_of = [&](double place) {
    return (std::upper_bound(under.begin(), under.end(), place) - under.begin()) % std::max<Eigen::Index>(1, count);
  };
  // Each crossing: twice the colour above is the sum of those below on either side. Closed, the last arc is the first.
  Eigen::MatrixXd colours = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const SeenCrossing& at = seen[static_cast<std::size_t>(i)];
    const double over = at.above > 0 ? at.first : at.second, below = at.above > 0 ? at.second : at.first;
    const Eigen::Index after = arc_of(below), before = (after + count - 1) % count;
    colours(i, arc_of(over)) += 2;
    colours(i, after) -= 1;
    colours(i, before) -= 1;
  }
  if (count < 2) return 1;
  return std::lround(std::abs(colours.topLeftCorner(count - 1, count - 1).determinant()));
}

std::optional<std::string> passed_through(const HardScene& hard, const Results& results) {
  const Fabric& fabric = results.scene.fabric;
  std::optional<std::vector<long>> linked;
  std::optional<long> knotted;
  for (const Snapshot& snapshot : results.snapshots) {
    const std::vector<long> numbers = linking_numbers(closed_curves(hard, fabric, snapshot.state.q));
    for (std::size_t i = 0; linked && i < numbers.size(); ++i)
      if (numbers[i] != (*linked)[i])
        return fmt::format("yarn passed through yarn: a linking number of {} became {} in stage {}, sample {}",
                           (*linked)[i], numbers[i], snapshot.stage, snapshot.sample);
    if (!linked) linked = numbers;
    if (!hard.tied) continue;
    const long determinant = knot_determinant(fabric, snapshot.state.q);
    if (determinant != knotted.value_or(determinant))
      return fmt::format("yarn passed through yarn: a knot of determinant {} became one of {}", *knotted, determinant);
    knotted = determinant;
  }
  if (!results.topology.intact())
    return fmt::format("a loop came out of another: {} of {} crossings are left", results.topology.found,
                       results.topology.expected);
  return {};
}

}  // namespace wale::stability
