/// Whether each side of a loop is still pulled through the loop that it should be.
#pragma once

#include <vector>

#include "sim/scene.hpp"

namespace wale {

/// Of the mean_net_crossing() of 2 that two pieces have which clasp, and 0 of two that do not.
inline constexpr double surely_clasped = 1.25;

/// The demanded crossings of a fabric, followed from state to state. Yarn slides through a pulled fabric, so that in
/// the end not the segments cross that the compiler named; from one state to the next it slides little.
class Clasps {
 public:
  struct Place {
    int side = 0, loop = 0;  ///< segments by which the pieces that cross lie beyond those that the compiler named
  };
  using Places = std::vector<Place>;

  Clasps(const Fabric&, const std::vector<Crossing>&);

  /// Which of the crossings a state has, in their order: over all directions of view, the side of a loop crosses the
  /// loop that it was pulled through twice, both times with `Crossing::sign`, rather than not at all, or links with it
  /// where the two are closed. The state may be in any pose. Between it and the one before, yarn may have slid by up to
  /// a quarter of a loop.
  std::vector<bool> follow(const Points& q);

  /// Where each clasp was in the last state; to go on from a state before that, go back to what it was there.
  const Places& places() const { return places_; }
  void go_back(const Places& places) { places_ = places; }

 private:
  double count(const Crossing&, const Place&, const Points& q) const;
  bool links(const Crossing&, const Place&, const Points& q) const;
  bool within_yarn(const Crossing&, const Place&) const;
  double climb(const Crossing&, Place&, const Points& q) const;

  const Fabric& fabric_;
  const std::vector<Crossing>& crossings_;
  Places places_;
};

/// Whether the two pieces of a crossing, where the compiler named them, cross twice with its sign when seen along
/// `along`.
bool crosses_twice(const Fabric&, const Crossing&, const Points& q, const Vec3& along);

}  // namespace wale
