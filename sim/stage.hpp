/// One stage of a scene made ready: the effects that it calls for, with its grips, and how it is measured.
#pragma once

#include <memory>

#include "sim/image.hpp"
#include "sim/results/recorder.hpp"
#include "sim/scene.hpp"
#include "sim/world.hpp"

namespace wale {

/// A stage, standing at its start. Grips hold what lies in them there.
class StageSetup {
 public:
  /// `start` is the state at the stage's beginning, with t = 0; `rest` are the rest lengths with which it
  /// begins; `travels` are the distances, m, by which the grips of a mount stand further apart at each sample so far,
  /// from 0.
  StageSetup(const Scene&, const Stage&, const State& start, const RestLengths& rest, const Sizes& relaxed,
             const std::vector<double>& travels = {0});

  /// A World to solve in; each call makes a new one, with the same answers.
  std::unique_ptr<World> world() const;
  /// One for measure(): asked about one state alone, so that no beads are kept twice.
  std::unique_ptr<World> world_to_measure() const { return world(false); }
  /// What a row of the results' table says of a state.
  std::vector<Quantity> measure(World&, const State&) const;
  /// Between the grips of a mount or a pull at the start, m.
  double gauge_length() const { return gauge_length_; }

 private:
  std::unique_ptr<World> world(bool lagged) const;
  void hold_ends();
  void mount_ends(const std::vector<double>& travels);
  void pull_ends();
  std::optional<Along> gripped() const;
  void guide_periods();
  void measure_grips(const double (&load)[2], double t, std::vector<Quantity>&) const;
  void measure_periods(const Eigen::Matrix<double, 3, 2>& on_periods, const State&, std::vector<Quantity>&) const;
  void measure_curl(double force, const Periods&, std::vector<Quantity>&) const;
  Tether grip_on(Along, std::size_t end) const;
  void close_grips(Along);
  void move_grips(Along, Schedule travel);
  const std::array<std::vector<int>, 2>& ends(Along) const;

  const Scene& scene_;
  const Stage& stage_;
  const State& start_;
  Sizes relaxed_;
  RestSchedules rest_;
  std::vector<EffectSpec> effects_;
  PeriodGuide guide_;
  double gauge_length_ = 0;  // m
  Schedule travel_;          // m, by which the grips stand further apart than where they closed
};

/// The mean position of some segments, m.
Vec3 centre_of(const Fabric&, const std::vector<int>& segments, const Points& q);

}  // namespace wale
