/// What every method is given alike: one stage of a scene, standing at its start.
#pragma once

#include <memory>
#include <string>

#include "sim/stage.hpp"

namespace wale::peers {

/// Not copyable: its worlds refer to it.
class Problem {
 public:
  /// The last stage of `scene`, after the others have been run. Throws std::runtime_error if one of them fails.
  explicit Problem(Scene scene);
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  /// For equilibria.
  std::unique_ptr<World> still() const;
  /// For motion: the same forces, and drag of 0.02 N s/m² (the peers' own).
  std::unique_ptr<World> moving() const;

  const Fabric& fabric() const { return scene_.fabric; }
  const State& start() const { return start_; }
  double duration() const { return stage().duration; }
  /// What the problem asks for in a state: the force on the grips, N, if there are any, else the energy, J.
  Quantity asked_of(const State&) const;

 private:
  const Stage& stage() const { return scene_.stages.back(); }

  Scene scene_;
  State start_;
  Stage damped_;
  std::unique_ptr<StageSetup> still_, moving_;
};

/// A jersey swatch as in examples/01_first_stitch: tightened roughly, and relaxed while cast-on and bind-off are held.
/// Let go whole, without friction, it would have no one rest position.
std::unique_ptr<Problem> relaxing(int wales, int courses);
/// The same swatch relaxed, then gripped and pulled along the wales to 40 % within `duration`, s.
std::unique_ptr<Problem> pulling(int wales, int courses, double duration);
/// One repeat of 2 x 2 stitches of jersey without end, relaxed, then pulled along the wales to `percent` of strain.
std::unique_ptr<Problem> pulling_cell(int segments_per_stitch, double percent);

}  // namespace wale::peers
