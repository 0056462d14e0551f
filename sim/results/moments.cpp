#include "sim/results/moments.hpp"

#include "sim/image.hpp"
#include "sim/results/curves.hpp"

namespace wale {

const Snapshot* relaxed_state(const Results& results) {
  const Snapshot* relaxed = nullptr;
  for (const Snapshot& snapshot : results.snapshots) {
    const Stage& stage = results.scene.stages[static_cast<std::size_t>(snapshot.stage)];
    relaxed = &snapshot;
    if (stage.grips()) break;
  }
  return relaxed;
}

std::optional<double> relaxed_curvature(const Results& results) {
  const auto& cell = results.scene.fabric.cell;
  if (!cell || !cell->may_curl() || results.scene.stages.empty()) return std::nullopt;
  const Snapshot* relaxed = relaxed_state(results);
  if (!relaxed) return std::nullopt;
  return curvature(*cell, relaxed->state.q.rightCols<2>());
}

const Snapshot* pulled_state(const Results& results) {
  const std::optional<std::size_t> row = most_strained_row(results.samples);
  if (!row || *row >= results.snapshots.size() || results.snapshots[*row].sample == 0) return nullptr;
  return &results.snapshots[*row];
}

}  // namespace wale
