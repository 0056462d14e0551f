/// The spirals that cast a fabric on and bind it off: Ding et al. 2023, Eq. (22).
#pragma once

#include "compiler/passes/loop_shape.hpp"

namespace wale {

/// A spiral along x that turns once a wale, round the sinkers of the first course or the heads of the last.
struct ChainSize {
  double radius = 0;  ///< λy,sp = λz,sp, m
  double level = 0;   ///< y of the sinkers' or heads' tips, m
  bool round_heads = false;
};

/// `x` along the strip, `centre` that of the wale it is in, `here` and its neighbours as in loop_point; `depth` is λz.
/// The derivative is by x.
Curve3 chain_point(const ChainSize&, const LoopSize&, int left_sign, int here_sign, int right_sign, double centre,
                   double x);

}  // namespace wale
