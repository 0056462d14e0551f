/// How the two periods of a periodic fabric are led in a stage.
#pragma once

#include <array>
#include <optional>

#include "sim/effect.hpp"
#include "sim/schedule.hpp"

namespace wale {

/// The course period lies along x and the wale period in the plane of x and y, so that a cell does not turn. What is
/// left are three lengths, each free, held or led by a schedule, and the curvature of a fabric that curls.
struct PeriodGuide {
  enum class How : std::uint8_t { free, held, led };
  struct Part {
    How how = How::free;
    Schedule length = 0.0;  ///< m, of the curl 1/m, if it is led
  };
  Part course;                  ///< x of the course period
  Part wale;                    ///< y of the wale period
  Part lean;                    ///< x of the wale period
  Part curl{.how = How::held};  ///< the curvature; held where it is 0 if the fabric may not curl

  /// Sets what is led to where it is at `state.t`, and lets the whole fabric of such a cell go along.
  void lead(const PeriodicCell&, State& state) const;
  /// By coordinate (rows) and period (columns): 1 where it may move, 0 where it may not.
  Eigen::Matrix<double, 3, 2> mobility() const;

 private:
  void stretch(State& state) const;
};

}  // namespace wale
