/// The contract of the physics: what acts on the yarns, and what a caller may ask of it.
#pragma once

#include <string_view>
#include <vector>

#include "sim/fabric.hpp"
#include "sim/stiffness.hpp"

namespace wale {

/// All that must be saved to go on: nothing else carries memory.
struct State {
  double t = 0;     ///< s; for a quasi-static solver the load parameter
  Points q, v;      ///< control points, m, and their velocities, m/s (3 x M)
  double step = 0;  ///< the solver's next step, s; 0 lets it choose
  Points a = {};    ///< accelerations, m/s², as the implicit solver balanced them; empty if none did
};

/// What a caller wants to know. A null member is not wanted, and costs nothing.
struct Load {
  double* energy = nullptr;        ///< V, J
  Points* force = nullptr;         ///< -dV/dq - dD/dv, N, 3 x M
  Stiffness* stiffness = nullptr;  ///< second derivative of V by q, N/m
  Stiffness* damping = nullptr;    ///< second derivative of D by v, N s/m
  double* dissipation = nullptr;   ///< D, W: the Rayleigh function; power lost is 2 D, if that is quadratic
  Stiffness* convex = nullptr;     ///< the stiffness less all that could make it indefinite (Gauss-Newton), N/m
  /// Of `damping`, 0 to 1: how far the slope of a force that levels off as it slides faster is taken as that from rest
  /// to here. At 1 no quadratic model with it promises more than there is to lose (Lange, Hunter & Yang 2000).
  double secant = 0;
};

/// Two segments that are near each other.
struct Gap {
  int a = 0, b = 0;                                 ///< segments
  Eigen::Vector2i image = Eigen::Vector2i::Zero();  ///< b is displaced by so many course and wale periods
  double distance = 0;                              ///< the smallest between their beads, m
  double diameter = 0;                              ///< below which they touch, m
};

/// Something that acts on the yarns: a stiffness, a contact, a grip, the air.
///
/// An effect is a function of the instant: same state, same answer, bit for bit, whatever was asked before and by
/// however many threads. It adds to what the Load holds; it never clears it. The sum of the columns of its force
/// is the true force, because the basis sums to one.
class Effect {
 public:
  virtual ~Effect() = default;
  virtual std::string_view name() const = 0;               ///< "stretch", "grip.top": in results and messages
  virtual bool dissipative() const { return false; }       ///< depends on velocity, and has no energy
  virtual void prepare(const State&) {}                    ///< bring caches up to date; cheap when little moved
  virtual void add(const State& at, Load& out) const = 0;  ///< the physics
  /// The smallest distance between yarns over their contact diameter, as `prepare` saw it; infinite if not looked at.
  virtual double closest() const;
  /// Appends the pairs of segments that are near each other, as `prepare` saw them.
  virtual void list_gaps(std::vector<Gap>&) const {}
};

}  // namespace wale
