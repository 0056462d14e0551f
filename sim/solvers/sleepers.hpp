/// Which parts of a fabric are at rest, so that a solver that follows a motion need not follow them.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/world.hpp"

namespace wale {

/// Yarns are cut into tiles of a dozen control points. A tile falls asleep when for some steps no force on its points
/// has been above `most`, nor has a point been faster than most / √(EA rho), at which yarn that is stopped pulls with
/// `most`; at once if it has never moved. It is then held where it is. It wakes as soon as a force on one of its points
/// is above `most`: that is known at each step, from what its neighbours and all that is led from outside do to it,
/// though what sleeping neighbours do to each other is not computed anew. So what is lost is what forces up to `most`
/// would have moved. Friction that has brought a tile to rest holds it as it did last.
class Sleepers {
 public:
  /// `most` in N. `world` must outlive this, and hold no points yet.
  Sleepers(World& world, const State& start, double most);
  Sleepers(const Sleepers&) = delete;
  Sleepers& operator=(const Sleepers&) = delete;
  ~Sleepers() { world_.hold({}); }

  /// Lets fall asleep and wakes, by the forces that the world answered at `state`, N; who falls asleep stops. True if
  /// the world holds other points now: then resume() must be given the forces that it answers now at the same state.
  bool review(State& state, const Points& force);
  void resume(const Points& force);

  /// Control points, ascending; at least those of one tile.
  const std::vector<int>& awake() const { return awake_; }
  double share_awake() const { return static_cast<double>(awake_.size()) / static_cast<double>(held_.size()); }

 private:
  struct Tile {
    int first = 0, count = 0;  ///< control points
    double slow = 0;           ///< m/s
    int quiet = 0;             ///< steps, up to now without a break
    bool asleep = false;
  };

  bool is_quiet(const Tile&, const State&) const;
  void let(Tile&, bool sleep, State&);
  void list_awake();

  World& world_;
  double most_;
  std::vector<Tile> tiles_;
  std::vector<std::uint8_t> held_;  // by control point
  std::vector<int> awake_;
  Points unseen_;  // what the world does not answer of the forces on points asleep, N
  Points force_;   // all of them, at the last review()
};

}  // namespace wale
