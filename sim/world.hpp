/// A fabric and all that acts on it in one stage.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "sim/constraints.hpp"
#include "sim/mass.hpp"
#include "sim/parts.hpp"

namespace wale {

/// Not copyable: effects refer to its parts. `fabric` must outlive it.
class World {
 public:
  /// `tightening`: see Parts. `start` is where the stage begins: tethers hold what lies there.
  World(const Fabric& fabric, std::vector<EffectSpec> effects, Schedule tightening, State start,
        const std::vector<Clamp>& clamps = {});
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void add(std::unique_ptr<Effect>);

  /// Brings the caches of every effect up to date; call before evaluate().
  void prepare(const State&);
  /// Clears what `out` asks for, then adds every effect.
  void evaluate(const State&, Load& out) const;
  /// q'' = M⁻¹ (force), under the constraints, m/s².
  void accelerate(const State&, Points& acceleration);

  /// A solver looks here within a step, and gives the step up when it is set. May be null; must outlive the world.
  void heed(const std::atomic<bool>* interrupt) { interrupt_ = interrupt; }
  bool interrupted() const { return interrupt_ && interrupt_->load(); }

  const Fabric& fabric() const { return fabric_; }
  const Mass& mass() const { return mass_; }
  const Constraints& constraints() const { return constraints_; }
  const std::vector<std::unique_ptr<Effect>>& effects() const { return effects_; }
  const Parts& parts() const { return parts_; }
  /// The smallest gap between yarns over their diameter, at the last prepare().
  double closest() const;

 private:
  const Fabric& fabric_;
  Schedule tightening_;
  State start_;
  Parts parts_;
  Mass mass_;
  Constraints constraints_;
  std::vector<std::unique_ptr<Effect>> effects_;
  const std::atomic<bool>* interrupt_ = nullptr;
};

/// The start of a run: control points as the compiler laid them, at rest.
State at_rest(const Fabric&);

}  // namespace wale
