/// How long yarns would like to be: tightened to their stitches, and shrunk.
#pragma once

#include <algorithm>
#include <vector>

#include "sim/scene.hpp"

namespace wale {

/// Rest lengths at one time.
struct RestLengths {
  double tightness = 0;        ///< from Segment::length (0) to Segment::knitted (1), Ding et al. 2023, Eq. A.7
  std::vector<double> left{};  ///< by material, the share of its length that shrinking has left it; empty: all of it

  RestLengths(double of_tightness = 0, std::vector<double> of_left = {})  // NOLINT: a number is how far it is tightened
      : tightness(of_tightness), left(std::move(of_left)) {}
  /// m
  double of(const Segment& segment) const {
    const double length = segment.length + (segment.knitted - segment.length) * tightness;
    return left.empty() ? length : length * left[static_cast<std::size_t>(segment.material)];
  }
  bool operator==(const RestLengths&) const = default;
};

/// How they change within a stage; as RestLengths.
struct RestSchedules {
  Schedule tightening;
  std::vector<Schedule> left{};

  RestSchedules(Schedule of_tightening = 0.0) : tightening(std::move(of_tightening)) {}  // NOLINT: nothing shrinks
  RestSchedules(double of_tightening) : tightening(of_tightening) {}                     // NOLINT: nor is tightened
  RestLengths operator()(double t) const;
  bool are_constant() const {
    return tightening.is_constant() &&
           std::all_of(left.begin(), left.end(), [](const Schedule& of) { return of.is_constant(); });
  }
};

/// `before`: rest lengths where the stage begins. `materials`: how many the fabric has.
RestSchedules rest_schedules(const Stage&, const RestLengths& before, std::size_t materials);

/// Those with which a stage of the scene begins; with all its stages, those with which the last one ends.
RestLengths rest_lengths_before(const Scene&, int stage);

}  // namespace wale
