/// What effects are made from: the fabric, the stage's rest length, the state at its start, and shared machinery.
#pragma once

#include <map>
#include <memory>
#include <utility>

#include "sim/effect.hpp"
#include "sim/scene.hpp"

namespace wale {

class Beads;

/// References outlive the effects that are made from these parts.
struct Parts {
  const Fabric& fabric;
  const Schedule& tightening;  ///< 0: rest length is Segment::length, 1: Segment::knitted
  const State& start;          ///< where the stage begins

  /// The rest length of a segment (Ding et al. 2023, Eq. A.7, segment by segment) where the tightening has come to
  /// `tightness`, m.
  static double rest_length(const Segment& of, double tightness) {
    return of.length + (of.knitted - of.length) * tightness;
  }
  /// The same at time t.
  double rest_length(int segment, double t) const { return rest_length(fabric.segment(segment), tightening(t)); }
  /// The contact beads for this sampling and screening, made when first asked for and shared by contact and its
  /// damping.
  std::shared_ptr<Beads> beads(double sampling, double screening);
  /// Those for effects that depend on velocity: the same, unless `lagged`.
  std::shared_ptr<Beads> dissipative_beads(double sampling, double screening);

  /// Whether effects that depend on velocity are asked about the positions where a step began, while the others are
  /// asked about those where it ends.
  bool lagged = false;
  std::map<std::pair<double, double>, std::shared_ptr<Beads>> made_beads{}, made_lagged_beads{};
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
std::unique_ptr<Effect> make(const Knots&, Parts&);

}  // namespace wale
