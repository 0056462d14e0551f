#include "tests/stability/invariants.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "sim/mass.hpp"
#include "tests/stability/passing_through.hpp"

namespace wale::stability {
namespace {

using Broken = std::optional<std::string>;

// What errors of the time steps may add, over the largest value.
constexpr double energy_error = 1e-3, angular_error = 1e-3, momentum_error = 1e-8;

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

Broken energy_grew(const HardScene& hard, const Results& results) {
  const Table& table = results.samples;
  if (!hard.only_loses || table.rows() == 0) return {};
  const std::vector<double> energy = energies(results, table), &stage = table.find("stage")->values;
  for (std::size_t row = 1; row < energy.size(); ++row) {
    if (stage[row] < hard.first_tested || stage[row] != stage[row - 1]) continue;
    if (!(energy[row] <= energy[row - 1] + energy_error * std::abs(energy[row - 1])))
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
