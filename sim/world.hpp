/// A fabric and all that acts on it in one stage.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "sim/constraints.hpp"
#include "sim/mass.hpp"
#include "sim/mid_surface.hpp"
#include "sim/parts.hpp"
#include "sim/period_inertia.hpp"
#include "sim/ties.hpp"

namespace wale {

/// Which effects are meant: those that depend on position, those that depend on velocity, or all.
enum class Acting : std::uint8_t { all, elastic, dissipative };

/// Not copyable: effects refer to its parts. `fabric` must outlive it.
class World {
 public:
  /// `rest`, `lagged`: see Parts. `start` is where the stage begins: tethers hold what lies there.
  World(const Fabric& fabric, std::vector<EffectSpec> effects, RestSchedules rest, State start,
        const std::vector<Clamp>& clamps = {}, bool lagged = false);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void add(std::unique_ptr<Effect>);
  /// How the periods of a periodic fabric are led; free if never said.
  void guide(PeriodGuide guide) { guide_ = std::move(guide); }

  /// Brings the caches of effects up to date; call before evaluate().
  void prepare(const State&, Acting = Acting::all);
  /// The next prepare() makes anew what is only brought up to date else, as that of a world just made does: which pairs
  /// that do not touch gaps() names depends on where it was asked before.
  void forget();
  /// Clears what `out` asks for, then adds every effect that is meant.
  void evaluate(const State&, Load& out, Acting = Acting::all) const;
  /// Adds every effect that is meant to what `out` holds.
  void add_to(Load& out, const State&, Acting = Acting::all) const;
  bool dissipates() const;
  /// q'' = M⁻¹ (force), under the constraints, m/s². `force`, if not null, becomes what evaluate() answers, N.
  void accelerate(const State&, Points& acceleration, Points* force = nullptr);

  /// Whether what does not move bears the same forces at any time, but for what is led from outside: rest lengths do
  /// not change, and no constraint reaches from one part to another.
  bool may_rest() const;
  /// From now on the control points that `held` marks do not move, and are not accelerated. What neighbours do to each
  /// other is left out where all of them are held, so that forces on these are known but for a constant, and energies
  /// are those of the rest. Empty: none is held. Call prepare() before the next evaluate().
  void hold(const std::vector<std::uint8_t>& held);

  /// A solver looks here within a step, and gives the step up when it is set. May be null; must outlive the world.
  void heed(const std::atomic<bool>* interrupt) { interrupt_ = interrupt; }
  bool interrupted() const { return interrupt_ && interrupt_->load(); }

  /// A solver shows where it goes within a step, so often that no yarn slides past another unseen. A step that it gives
  /// up is shown as well, and the next try begins where that began. `watcher` may be empty.
  void watch(std::function<void(const Points&)> watcher) { watcher_ = std::move(watcher); }
  void show(const Points& q) const {
    if (watcher_) watcher_(q);
  }

  const Fabric& fabric() const { return fabric_; }
  /// Those of a fabric that curls are as they were at the last prepare() of what is elastic.
  const Ties& ties() const { return ties_; }
  const PeriodGuide& guide() const { return guide_; }
  const Mass& mass() const { return mass_; }
  const PeriodInertia& period_inertia() const { return period_inertia_; }
  /// Of a periodic fabric that of its motion beside the flow of its periods, and that of free periods, J.
  double kinetic_energy(const State&) const;
  /// Those of a fabric that curls hold its mid-surface, as it was at the last prepare() of what is elastic.
  const Constraints& constraints() const { return constraints_; }
  /// A force on what may move without what holds its mid-surface, of a fabric that curls and rests, at the last
  /// prepare(): then none is left on yarn, and that on the periods is conjugate to them with the mid-surface kept, N.
  Points beside_mid_surface(const Points& force) const;
  /// Whether a repeat of a fabric that curls stays within half a turn about its axis.
  bool fits_around(const State& state) const;
  /// Brings a state of a fabric that curls, after it has moved, back to where its mid-surface is held, and what follows
  /// along.
  void settle(State& state) const {
    if (mid_surface_) mid_surface_->settle(state.q);
    ties_.follow(state.q);
  }
  const std::vector<std::unique_ptr<Effect>>& effects() const { return effects_; }
  const Parts& parts() const { return parts_; }
  /// The smallest gap between yarns over their diameter, at the last prepare().
  double closest() const;
  /// The pairs of segments that are near each other, at the last prepare().
  std::vector<Gap> gaps() const;

 private:
  void hold_mid_surface(const Points& q);

  const Fabric& fabric_;
  RestSchedules rest_;
  State start_;
  Parts parts_;
  Ties ties_;
  PeriodGuide guide_;
  Mass mass_;
  PeriodInertia period_inertia_;
  std::vector<std::uint8_t> held_;         // by control point; empty: none is
  std::optional<Mass> moving_mass_{};      // of the others, if some are held
  std::optional<MidSurface> mid_surface_;  // of a fabric that curls
  Points height_slope_;                    // of its height by what may move
  Constraints constraints_;
  std::vector<std::unique_ptr<Effect>> effects_;
  const std::atomic<bool>* interrupt_ = nullptr;
  std::function<void(const Points&)> watcher_;
};

/// The start of a run: control points as the compiler laid them, at rest; of a periodic fabric also its periods, as two
/// more columns.
State at_rest(const Fabric&);

}  // namespace wale
