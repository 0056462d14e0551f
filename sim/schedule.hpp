/// A number that changes with time, piecewise linearly.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace wale {

/// Linear between the given knots, constant outside them. Without knots it is the constant given.
class Schedule {
 public:
  struct Knot {
    double t = 0, value = 0;
    bool operator==(const Knot&) const = default;
  };
  Schedule(double constant = 0) : knots_{{0, constant}} {}  // NOLINT: a number is a schedule
  /// `knots` in ascending t, at least one.
  explicit Schedule(std::vector<Knot> knots) : knots_(std::move(knots)) {}
  /// From `from` at t = 0 to `to` at t = `duration` (Ding et al. 2023, Eq. A.7 when it scales a rest length).
  static Schedule ramp(double from, double to, double duration) { return Schedule({{0, from}, {duration, to}}); }

  double operator()(double t) const {
    if (t <= knots_.front().t) return knots_.front().value;
    for (std::size_t i = 1; i < knots_.size(); ++i) {
      const Knot &a = knots_[i - 1], &b = knots_[i];
      if (t <= b.t) return b.t > a.t ? a.value + (b.value - a.value) * (t - a.t) / (b.t - a.t) : b.value;
    }
    return knots_.back().value;
  }
  /// How fast it changes at `t`, a second; at a knot, before it.
  double rate(double t) const {
    if (t <= knots_.front().t) return 0;
    for (std::size_t i = 1; i < knots_.size(); ++i) {
      const Knot &a = knots_[i - 1], &b = knots_[i];
      if (t <= b.t) return b.t > a.t ? (b.value - a.value) / (b.t - a.t) : 0;
    }
    return 0;
  }
  /// The same with all its values multiplied.
  Schedule times(double factor) const {
    std::vector<Knot> knots = knots_;
    for (Knot& knot : knots) knot.value *= factor;
    return Schedule(std::move(knots));
  }
  /// The same, `factor` times as long.
  Schedule over(double factor) const {
    std::vector<Knot> knots = knots_;
    for (Knot& knot : knots) knot.t *= factor;
    return Schedule(std::move(knots));
  }
  const std::vector<Knot>& knots() const { return knots_; }
  bool is_constant() const {
    return std::all_of(knots_.begin(), knots_.end(), [&](const Knot& knot) { return knot.value == knots_[0].value; });
  }
  bool operator==(const Schedule&) const = default;

 private:
  std::vector<Knot> knots_;
};

}  // namespace wale
