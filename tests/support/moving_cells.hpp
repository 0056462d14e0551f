/// Periodic fabrics that move, under guides of their own.
#pragma once

#include "sim/tile.hpp"
#include "sim/world.hpp"
#include "tests/support/cells.hpp"

namespace wale {

/// Where a repeat lies, to be moved from there.
struct LaidCell {
  Fabric fabric;
  Points q;  ///< and its periods, m
};

/// A tightened repeat of jersey of one stitch, at rest.
inline LaidCell resting_stitch(int segments = 8) {
  Stage rest;
  rest.samples = 1;
  Results results = run_cell({.picture = {"k"}, .segments_per_stitch = segments, .tolerance = 1e-6}, rest);
  return {std::move(results.scene.fabric), results.snapshots.back().state.q};
}

/// `across` x `up` of its repeats as one.
inline LaidCell several(const LaidCell& of, int across, int up) {
  LaidCell more{tile(of.fabric, of.q, across, up), {}};
  more.fabric.cell = PeriodicCell{across * of.q.rightCols<2>().col(0), up * of.q.rightCols<2>().col(1)};
  more.q = points_and_periods(more.fabric);
  return more;
}

/// The same, each yarn of it begun `later` segments further on.
inline LaidCell begun_later(const LaidCell& of, int later) {
  const Fabric twice = tile(of.fabric, of.q, 2, 1);
  LaidCell moved = of;
  for (std::size_t y = 0; y < of.fabric.yarns.size(); ++y) {
    const Yarn& yarn = of.fabric.yarns[y];
    for (int k = 0; k < yarn.points(); ++k)
      moved.q.col(yarn.first_point + k) = twice.points.col(twice.yarns[y].first_point + k + later);
    for (int k = 0; k < yarn.segments; ++k)
      moved.fabric.segments[static_cast<std::size_t>(yarn.first_segment + k)] =
          of.fabric.segment(yarn.first_segment + (k + later) % yarn.segments);
  }
  moved.fabric.points = moved.q.leftCols(of.fabric.points.cols());
  return moved;
}

inline PeriodGuide::Part held() { return {.how = PeriodGuide::How::held}; }
inline PeriodGuide::Part led(Schedule length) { return {.how = PeriodGuide::How::led, .length = std::move(length)}; }

/// The wale period goes by these strains in turn, each reached after as many seconds again; across it is held, unless
/// that is another part.
inline PeriodGuide lengthened(const LaidCell& cell, const std::vector<double>& strains, double each,
                              PeriodGuide::Part across = held()) {
  const double length = cell.q(1, cell.q.cols() - 1);
  std::vector<Schedule::Knot> knots{{0, length}};
  for (const double strain : strains) knots.push_back({knots.back().t + each, (1 + strain) * length});
  return {std::move(across), led(Schedule(std::move(knots))), held()};
}

class MovingCell {
 public:
  MovingCell(LaidCell cell, const std::vector<EffectSpec>& effects, PeriodGuide guide = {held(), held(), held()})
      : cell_(std::move(cell)),
        start_{.t = 0, .q = cell_.q, .v = Points::Zero(3, cell_.q.cols()), .step = 0},
        world_(cell_.fabric, effects, Schedule(1.0), start_, {}, true) {
    world_.guide(std::move(guide));
  }

  World& world() { return world_; }
  const State& start() const { return start_; }

  /// The same with these velocities of what does not follow, and still periods.
  State struck(double speed, unsigned seed) const {
    State state = start_;
    Points own = world_.ties().pick(state.v);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-speed, speed);
    for (double& x : own.leftCols(own.cols() - 2).reshaped()) x += noise(random);
    state.v = world_.ties().spread(own);
    return state;
  }

  double kinetic(const State& at) const { return world_.kinetic_energy(at); }
  double energy(const State& at) {
    double stored = 0;
    Load load{.energy = &stored};
    world_.prepare(at);
    world_.evaluate(at, load);
    return stored + kinetic(at);
  }
  Vec3 momentum(const State& at) const { return world_.mass().times(beside_flow(at)).rowwise().sum(); }
  /// What leads the periods bears, N: by coordinate and period.
  Eigen::Matrix<double, 3, 2> load(const State& at) {
    Points force;
    Load wanted{.force = &force};
    world_.prepare(at);
    world_.evaluate(at, wanted);
    return -force_on_flow(force, at, world_.mass());
  }

 private:
  LaidCell cell_;
  State start_;
  World world_;
};

}  // namespace wale
