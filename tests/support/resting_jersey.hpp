/// A piece of an endless jersey at rest, framed by tethers; what of it lies far from a hook or a ball is not moved by
/// them.
#pragma once

#include "sim/tile.hpp"
#include "sim/world.hpp"
#include "tests/support/cells.hpp"

namespace wale {

class RestingJersey {
 public:
  /// As many stitches each way, an even number. Throws std::runtime_error if no rest is found.
  explicit RestingJersey(int stitches, int segments_per_stitch = 12) {
    constexpr int stitches_of_repeat = 2;
    Stage rest;
    rest.samples = 1;
    const Results cell = run_cell({.segments_per_stitch = segments_per_stitch, .tolerance = 1e-5}, rest);
    const int repeats = stitches / stitches_of_repeat;
    fabric_ = tile(cell.scene.fabric, cell.snapshots.back().state.q, repeats, repeats);
    for (Segment& segment : fabric_.segments) segment.length = segment.knitted;
    laid_ = rest_ = at_rest(fabric_);
    frame(segments_per_stitch);
    settle();
  }
  RestingJersey(const RestingJersey&) = delete;
  RestingJersey& operator=(const RestingJersey&) = delete;

  const Fabric& fabric() const { return fabric_; }
  const State& state() const { return rest_; }

  /// A world in which it rests, but for `others`.
  std::unique_ptr<World> world(const std::vector<EffectSpec>& others) const {
    std::vector<EffectSpec> effects{Stretch{}, Bend{}, Contact{}, frame_};
    effects.insert(effects.end(), others.begin(), others.end());
    return std::make_unique<World>(fabric_, std::move(effects), 0.0, laid_);
  }

  Vec3 middle() const { return (rest_.q.rowwise().minCoeff() + rest_.q.rowwise().maxCoeff()) / 2; }

  /// Two segments in the middle, hooked and moved by `by` along the wales, m; `when` goes from 0 to 1.
  Tether hook(double by, Schedule when) const {
    int nearest = 0;
    const auto off = [&](int segment) { return (rest_.q.col(fabric_.first_point(segment)) - middle()).norm(); };
    for (int i = 0; i < fabric_.segment_count(); ++i)
      if (off(i) < off(nearest)) nearest = i;
    return {.label = "hook",
            .segments = {nearest, nearest + 1},
            .stiffness = 1e5,
            .move = {0, by, 0},
            .progress = std::move(when)};
  }

  /// A ball in front of the middle that moves `by` towards it, m.
  Obstacle ball(double by, Schedule when) const {
    const double radius = 2e-3, front = rest_.q.row(2).maxCoeff() + fabric_.materials[0].diameter / 2;
    return {.label = "ball",
            .shape = Obstacle::Shape::sphere,
            .centre = {middle().x(), middle().y(), front + radius},
            .radius = radius,
            .move = {0, 0, -by},
            .progress = std::move(when)};
  }

 private:
  /// The stitches at the edge.
  void frame(int segments_per_stitch) {
    frame_.label = "frame";
    for (std::size_t row = 0; row < fabric_.yarns.size(); ++row) {
      const Yarn& yarn = fabric_.yarns[row];
      const bool whole = row == 0 || row + 1 == fabric_.yarns.size();
      for (int place = 0; place < yarn.segments; ++place)
        if (whole || place < segments_per_stitch || place >= yarn.segments - segments_per_stitch)
          frame_.segments.push_back(yarn.first_segment + place);
    }
  }

  void settle() {
    const auto made = world({});
    const auto solver = make(QuasiStatic{.tolerance = 1e-6}, *made, rest_);
    while (true) {
      const Progress progress = solver->advance(1);
      if (progress == Progress::failed) throw std::runtime_error(solver->effort().failure);
      if (progress == Progress::arrived || solver->state().t >= 1) break;
    }
    rest_.q = solver->state().q;
  }

  Fabric fabric_;
  State laid_, rest_;
  Tether frame_;
};

}  // namespace wale
