/// How the two periods of a periodic fabric are led in a stage.
#pragma once

#include <array>
#include <optional>

#include "sim/effect.hpp"
#include "sim/mass.hpp"
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
  /// Gives each period that is not free its rate from `state.t` to `until`, between which no schedule turns, and lets
  /// the fabric go along, unchanged beside the flow; whether it went otherwise.
  bool pace(State& state, double until) const;
  bool leaves_free() const { return course.how == How::free || wale.how == How::free || lean.how == How::free; }
  /// By coordinate (rows) and period (columns): 1 where it may move, 0 where it may not.
  Eigen::Matrix<double, 3, 2> mobility() const;

 private:
  void stretch(State& state) const;
};

/// Where columns lie, or move, in periods H: H⁻¹ x, by x and y; 2 x M + 2. The periods themselves are the unit vectors.
Eigen::Matrix2Xd in_periods(const Points& x, const State& at);

/// Velocities beside the flow of the periods, u = v - dH/dt H⁻¹ q: the same wherever a repeat is cut, and of as many
/// repeats as one likes; m/s. Of the periods zero.
Points beside_flow(const State& at);

/// The force conjugate to the periods when the whole fabric flows with them, Σ f ⊗ H⁻¹ q + Σ M u ⊗ H⁻¹ u, N: its power
/// on dH/dt is what a fabric that moves gives off of ½ u·M u and of what it stores. `force` acts on the columns of
/// State::q. At rest it is the force on the periods alone.
Eigen::Matrix<double, 3, 2> force_on_flow(const Points& force, const State& at, const Mass& mass);

}  // namespace wale
