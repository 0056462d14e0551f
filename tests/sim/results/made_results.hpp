/// Results with something in every member, for tests of what is written.
#pragma once

#include <cmath>
#include <limits>
#include <random>

#include "sim/results/recorder.hpp"
#include "tests/sim/results/made_jersey.hpp"

namespace wale::testing {

inline Points random_points(Eigen::Index columns, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, 1e-3);
  Points points(3, columns);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = normal(random);
  return points;
}

/// A pull of five samples after a stage without a strain; stress is 1 kPa at 10 % and grows as a J.
inline Results made_results() {
  const MadeJersey made = made_jersey(3, 4);
  Results results;
  results.manifest = {"0.1.0", "a host", "2020-01-02T03:04:05Z", 2, 0.01, 1, {{"a.yaml", "chart: ü\n"}, {"b.yaml", ""}}};
  results.scene.name = "swatch";
  results.scene.fabric = made.fabric;
  results.scene.fabric.materials.push_back({"soft", 1e-6, 2, 3e-9, 0.1 + 0.2, ContactLaw::core_shell, 5, 1e-4, 2.5});
  results.scene.fabric.source = "a.yaml";
  for (Segment& segment : results.scene.fabric.segments) segment.line = segment.stitch + 1, segment.column = 7;
  results.scene.gauge = made.gauge;
  results.scene.gauge.thickness = 1.048e-3;
  results.scene.clamps = {{1, true, false, true}, {0, false, true, false}};
  results.scene.crossings = made.crossings;
  append_row(results.samples,
             {{"stage", "", 0}, {"t", "s", 1}, {"energy.stretch", "J", 1e-6}, {"energy.grip/top", "J", 0}});
  for (int i = 0; i < 5; ++i) {
    const double strain = 0.15 * i;
    append_row(results.samples, {{"stage", "", 1},
                                 {"t", "s", 0.25 * i},
                                 {"strain", "", strain},
                                 {"stress", "Pa", 1e4 * strain + 1e6 * std::pow(strain, 4)},
                                 {"force", "N", strain / 3},
                                 {"force_per_wale", "N", strain / 9},
                                 {"energy.stretch", "J", 1e-3 * strain},
                                 {"energy.bend", "J", -0.0}});
  }
  for (int i = 0; i < 6; ++i) {
    const Eigen::Index points = made.fabric.points.cols();
    results.snapshots.push_back({i > 0,
                                 i,
                                 {0.1 * i, made.fabric.points + random_points(points, 7 + i) * 0.01,
                                  random_points(points, 100 + i), 1e-310 * i}});
  }
  results.snapshots.back().sample = -1;
  results.snapshots[1].state.v(2, 3) = std::numeric_limits<double>::quiet_NaN();
  results.phases = {{"compile", 0.5}, {"tighten", 2}, {"relax", 1}, {"pull", 8}, {"write", 0.25}};
  results.relaxed = {1e-3, 2e-3, 3e-3, 4e-3, 5e-3};
  results.effort = {10, 2, 345, 67, 12.5, {5, 4, 3, 2}, "the step became too small"};
  results.topology = {18, 17};
  results.contact_samples = 1234567890123;
  results.warnings = {"the fabric is tight", ""};
  results.complete = true;
  return results;
}

}  // namespace wale::testing
