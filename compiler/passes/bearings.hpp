/// How each loop lies at the anchors that it hangs from: in which layer, how wide, how deep.
#pragma once

#include <vector>

#include "compiler/arrangement.hpp"
#include "compiler/passes/hung_loop.hpp"

namespace wale {

class Bearings {
 public:
  /// The arguments must outlive it; `diameter` is that of the thickest yarn, m.
  Bearings(const StitchGraph&, const Arrangement&, const LoopSize&, double diameter);

  /// Of a loop from its feet to its head, or to the anchor that it passes first. A tube's strip passes every place once
  /// a round: nearest to `x`.
  Bearing of(int loop, double x) const;
  Bearing of(int loop, int head, double x) const;

  /// Whether one foot of a row goes over into the next, because the loops lie side by side.
  bool side_by_side(const YarnStep&) const;

 private:
  struct Width {
    double left = 1, right = 1;
  };
  const Hanging& hanging(int loop) const { return arrangement_.loops[static_cast<std::size_t>(loop)]; }
  const Anchor& anchor(int i) const { return arrangement_.anchors[static_cast<std::size_t>(i)]; }
  Vec3 ahead(const YarnStep&) const;
  void find_widths();
  Width width_of_head(const Anchor&) const;
  Footing footing(int anchor_index, int loop, bool head, double x) const;
  void lay_along_edge(int loop, Footing&) const;
  void lay_aside(int loop, double forward, Footing&) const;
  bool holds_chain(const Anchor&) const;

  const StitchGraph& graph_;
  const Arrangement& arrangement_;
  const LoopSize& size_;
  double diameter_;
  std::vector<Width> widths_;  // of each loop's feet
};

}  // namespace wale
