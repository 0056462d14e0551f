/// What effects are made from: the fabric, the stage's rest length, the state at its start, and shared machinery.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "sim/effect.hpp"
#include "sim/rest_length.hpp"

namespace wale {

class Beads;

/// References outlive the effects that are made from these parts.
struct Parts {
  const Fabric& fabric;
  const RestSchedules& rest;
  const State& start;  ///< where the stage begins

  /// The contact beads of an effect (see Contact), made when first asked for and shared by all that are alike.
  std::shared_ptr<Beads> beads(double sampling, double screening, double skin);
  /// Those for effects that depend on velocity: the same, unless `lagged`.
  std::shared_ptr<Beads> dissipative_beads(double sampling, double screening, double skin);

  /// Whether effects that depend on velocity are asked about the positions where a step began, while the others are
  /// asked about those where it ends.
  bool lagged = false;
  /// By segment, whether its four control points are held by World::hold(), so that nobody asks what it does to them;
  /// empty if no point is.
  std::vector<std::uint8_t> asleep{};
  std::map<std::array<double, 3>, std::shared_ptr<Beads>> made_beads{}, made_lagged_beads{};
};

/// One factory an effect, beside its physics in sim/effects/.
std::unique_ptr<Effect> make(const Stretch&, Parts&);
std::unique_ptr<Effect> make(const Bend&, Parts&);
std::unique_ptr<Effect> make(const Gravity&, Parts&);
std::unique_ptr<Effect> make(const Drag&, Parts&);
std::unique_ptr<Effect> make(const Contact&, Parts&);
std::unique_ptr<Effect> make(const ContactDamping&, Parts&);
std::unique_ptr<Effect> make(const Friction&, Parts&);
std::unique_ptr<Effect> make(const Tether&, Parts&);
std::unique_ptr<Effect> make(const Plates&, Parts&);
std::unique_ptr<Effect> make(const Obstacle&, Parts&);
std::unique_ptr<Effect> make(const Pressure&, Parts&);
std::unique_ptr<Effect> make(const Twist&, Parts&);
std::unique_ptr<Effect> make(const Knots&, Parts&);

}  // namespace wale
