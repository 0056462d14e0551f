#include "sim/solvers/sleepers.hpp"

#include <algorithm>
#include <cmath>

namespace wale {
namespace {

constexpr int tile_length = 12;
constexpr int patience = 64;  // steps: where stability bounds them, sound passes two tiles in these

}  // namespace

Sleepers::Sleepers(World& world, const State& start, double most)
    : world_(world),
      most_(most),
      held_(static_cast<std::size_t>(start.q.cols())),
      unseen_(Points::Zero(3, start.q.cols())) {
  if (world.may_rest())
    for (const Yarn& yarn : world.fabric().yarns)
      for (int place = 0; place < yarn.points(); place += tile_length) {
        const Material& of = world.fabric().material_of(yarn.first_segment + std::min(place, yarn.segments - 1));
        Tile tile{.first = yarn.first_point + place,
                  .count = std::min(tile_length, yarn.points() - place),
                  .slow = most / std::sqrt(of.axial_stiffness * of.linear_density)};
        if (start.v.middleCols(tile.first, tile.count).isZero(0)) tile.quiet = patience;
        tiles_.push_back(tile);
      }
  list_awake();
}

bool Sleepers::review(State& state, const Points& force) {
  force_ = force + unseen_;
  bool changed = false;
  auto awake = std::count_if(tiles_.begin(), tiles_.end(), [](const Tile& tile) { return !tile.asleep; });
  for (Tile& tile : tiles_) {
    tile.quiet = is_quiet(tile, state) ? tile.quiet + 1 : 0;
    const bool sleep = tile.asleep ? tile.quiet > 0 : tile.quiet > patience && awake > 1;
    if (sleep == tile.asleep) continue;
    awake += sleep ? -1 : 1;
    let(tile, sleep, state);
    changed = true;
  }
  if (!changed) return false;
  list_awake();
  world_.hold(held_);
  return true;
}

void Sleepers::resume(const Points& force) {
  unseen_ = force_ - force;
  for (const int point : awake_) unseen_.col(point).setZero();
}

bool Sleepers::is_quiet(const Tile& tile, const State& state) const {
  const auto largest = [&](const Points& of) {
    return of.middleCols(tile.first, tile.count).colwise().squaredNorm().maxCoeff();
  };
  return largest(force_) <= most_ * most_ && largest(state.v) <= tile.slow * tile.slow;
}

void Sleepers::let(Tile& tile, bool sleep, State& state) {
  tile.asleep = sleep;
  std::fill_n(held_.begin() + tile.first, tile.count, sleep);
  if (sleep) state.v.middleCols(tile.first, tile.count).setZero();
}

void Sleepers::list_awake() {
  awake_.clear();
  for (std::size_t point = 0; point < held_.size(); ++point)
    if (!held_[point]) awake_.push_back(static_cast<int>(point));
}

}  // namespace wale
