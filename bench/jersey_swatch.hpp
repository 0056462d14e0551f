/// What the timings of forces and of solver steps are made on.
#pragma once

#include "sim/world.hpp"

namespace wale {

/// Jersey as a chart lays it, shrunk as if tightened, so that its loops touch; in a world of its own. Not copyable.
class JerseySwatch {
 public:
  enum class Mounting : std::uint8_t {
    free,
    gripped  ///< between two grips along the wales and two plates
  };
  /// `shrinkage` is of all coordinates.
  JerseySwatch(int wales, int courses, double shrinkage, Mounting);

  /// Prepares, and answers the energy, J.
  double evaluate();
  /// At the last evaluate(), N.
  const Points& force() const { return force_; }
  /// Moves every control point, m.
  void move(const Points& by) { state_.q += by; }

  World& world() { return *world_; }
  const World& world() const { return *world_; }
  const State& state() const { return state_; }
  const Fabric& fabric() const { return fabric_; }

 private:
  Fabric fabric_;
  State state_;
  std::unique_ptr<World> world_;
  Points force_;
};

}  // namespace wale
