#include "tests/stability/invariants.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sim/mass.hpp"
#include "tests/stability/passing_through.hpp"

namespace wale::stability {
namespace {

using Broken = std::optional<std::string>;

// What errors of the time steps may add: of a momentum over the sum of its parts.
constexpr double angular_error = 1e-3, momentum_error = 1e-8;
constexpr double drowned = 1e-9;  // of the largest energy: rounding
constexpr double unbalanced = 1;  // diameters, over which the force that is let stand may do work

Broken not_finite(const Results& results) {
  for (const Snapshot& snapshot : results.snapshots)
    if (!snapshot.state.q.allFinite() || !snapshot.state.v.allFinite() || !std::isfinite(snapshot.state.t))
      return fmt::format("not finite in stage {} at sample {}", snapshot.stage, snapshot.sample);
  return {};
}

bool in_time(const Stage& stage) { return !std::holds_alternative<QuasiStatic>(stage.solver); }

/// By row of the results' table; that of a motion has its kinetic energy in it.
std::vector<double> energies(const Results& results, const Table& table) {
  std::vector<double> sums(table.rows(), 0);
  for (const Column& column : table.columns)
    for (std::size_t row = 0; column.name.starts_with("energy.") && row < sums.size(); ++row) {
      const auto stage = static_cast<std::size_t>(table.find("stage")->values[row]);
      const bool counts = column.name != "energy.kinetic" || in_time(results.scene.stages[stage]);
      if (counts && !std::isnan(column.values[row])) sums[row] += column.values[row];
    }
  return sums;
}

/// By how much an energy of `before` may grow, J: by errors of the time steps, and by rounding beside the `largest`;
/// where forces balance, by what the force that is let stand may do.
double energy_error(const SolverSpec& solver, const Fabric& fabric, double before, double largest) {
  if (const auto* still = std::get_if<QuasiStatic>(&solver))
    return allowed_residual(*still, fabric) * unbalanced * fabric.materials.front().diameter;
  const auto* implicit = std::get_if<Implicit>(&solver);
  const double relative = implicit ? 3 * implicit->relative : 10 * std::get<RungeKutta>(solver).relative;
  return relative * std::abs(before) + drowned * largest;
}

Broken energy_grew(const HardScene& hard, const Results& results) {
  const Table& table = results.samples;
  if (!hard.only_loses || table.rows() == 0) return {};
  const std::vector<double> energy = energies(results, table), &stage = table.find("stage")->values;
  const double largest = *std::max_element(energy.begin(), energy.end());
  for (std::size_t row = 1; row < energy.size(); ++row) {
    if (stage[row] < hard.first_tested || stage[row] != stage[row - 1]) continue;
    const SolverSpec& solver = results.scene.stages[static_cast<std::size_t>(stage[row])].solver;
    const double error = energy_error(solver, results.scene.fabric, energy[row - 1], largest);
    if (!(energy[row] <= energy[row - 1] + error))
      return fmt::format("energy grew from {:.4g} J to {:.4g} J", energy[row - 1], energy[row]);
  }
  return {};
}

Vec3 turning(const Points& q, const Points& momentum) {
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index k = 0; k < q.cols(); ++k) sum += Vec3(q.col(k)).cross(Vec3(momentum.col(k)));
  return sum;
}

Broken momentum_changed(const HardScene& hard, const Results& results) {
  if (!hard.by_itself) return {};
  const Mass mass(results.scene.fabric);
  for (const Snapshot& snapshot : results.snapshots) {
    if (snapshot.stage < hard.first_tested || !in_time(results.scene.stages[static_cast<std::size_t>(snapshot.stage)]))
      continue;
    const Points momentum = mass.times(snapshot.state.v);
    const double all = momentum.colwise().norm().sum(), arm = snapshot.state.q.colwise().norm().maxCoeff();
    if (momentum.rowwise().sum().norm() > momentum_error * all)
      return fmt::format("momentum grew to {:.2g} of its parts", momentum.rowwise().sum().norm() / all);
    if (turning(snapshot.state.q, momentum).norm() > angular_error * all * arm)
      return fmt::format("angular momentum grew to {:.2g} of its parts",
                         turning(snapshot.state.q, momentum).norm() / (all * arm));
  }
  return {};
}

}  // namespace

Broken what_broke(const HardScene& hard, const Results& results) {
  Broken broken = not_finite(results);
  if (!broken) broken = passed_through(hard, results);
  if (!broken) broken = energy_grew(hard, results);
  if (!broken) broken = momentum_changed(hard, results);
  return broken;
}

}  // namespace wale::stability
