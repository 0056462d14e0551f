/// The four beds of needles and sliders, and the loops that they hold.
#pragma once

#include <array>
#include <vector>

#include "compiler/stitch_graph.hpp"

namespace wale {

/// The loops on a needle from the hook's base to its tip: what comes later lies nearer the gap between the beds.
using LoopStack = std::vector<int>;

/// Seen from the front: front hooks open to the back, so that the base lies foremost; back hooks the other way.
LoopStack front_to_back(const Needle&, const LoopStack&);

/// The loops of every needle that a program names, in one flat array a bed.
class NeedleBeds {
 public:
  explicit NeedleBeds(const Program&);

  /// A needle that the program names, not farther out than `farthest_needle`.
  LoopStack& at(const Needle& needle) {
    return beds_[static_cast<std::size_t>(needle.bed)][static_cast<std::size_t>(needle.index - first_)];
  }

  /// Every needle that holds a loop, by bed, then from left to right.
  std::vector<HeldLoops> held() const;

 private:
  int first_ = 0;
  std::array<std::vector<LoopStack>, 4> beds_;  // by Bed
};

}  // namespace wale
