/// What a run leaves behind: one schema for every writer.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene.hpp"
#include "sim/solver.hpp"

namespace wale {

struct Column {
  std::string name, unit;  ///< "energy.bend", "J"
  std::vector<double> values;
};

/// One row a sample. Columns exist only for effects that exist; a column that a stage lacks holds NaN there.
struct Table {
  std::vector<Column> columns;
  std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
  const Column* find(std::string_view name) const;
};

/// A saved state, and the stage that it belongs to.
struct Snapshot {
  int stage = 0;
  int sample = 0;  ///< samples of that stage done, 0 at its start; -1 between two samples (interrupted there)
  State state;
};

struct Text {
  std::string name, text;
};

/// Where a run came from, so that a file explains itself and can be resumed.
struct Manifest {
  std::string version, host, when;
  int threads = 1;
  double accuracy = 0;        ///< that was asked for, of the stress over its peak; 0: settings as written
  int refinements = 0;        ///< times by which settings were made finer than an accuracy at first asks for
  std::vector<Text> sources;  ///< the scene first, then what it read
};

struct Phase {
  std::string name;  ///< "compile", "tighten", "relax", "pull", "write"
  double seconds = 0;
};
/// Of all phases, s.
inline double total_seconds(const std::vector<Phase>& phases) {
  double sum = 0;
  for (const Phase& phase : phases) sum += phase.seconds;
  return sum;
}

/// Lengths of a relaxed fabric, m; see sim/results/curves.hpp for how they are measured.
struct Sizes {
  double course_spacing = 0, wale_spacing = 0, width = 0, length = 0, thickness = 0;
};

/// Crossings that the stitch graph demands, and those found in the worst saved state.
struct Topology {
  long expected = 0, found = 0;
  bool intact() const { return expected == found; }
};

struct Results {
  Manifest manifest;
  Scene scene;                      ///< with its fabric as compiled
  Table samples;                    ///< `stage`, `t`, `strain`, `force`, `force_per_wale`, `stress`, `energy.*`, ...
  std::vector<Snapshot> snapshots;  ///< one a row of `samples`; at most one more, at the end, from an interruption
  std::vector<Phase> phases;
  Sizes relaxed;
  Effort effort;
  Topology topology;
  std::optional<double> estimated_error;  ///< of the stress over its peak, by a second solution
  long contact_samples = 0;               ///< beads in all yarns
  std::vector<std::string> warnings;
  bool complete = false;
};

}  // namespace wale
