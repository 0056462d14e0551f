#include "compiler/passes/chain_shape.hpp"

#include <cmath>
#include <numbers>

#include "compiler/passes/smooth_step.hpp"

namespace wale {
namespace {

constexpr double blend_width = 0.4;  // of a wale, on either side of the middle between two; see ArcLength for its steps

/// Depth of the row that the spiral goes round: -s, blended from wale to wale; in λz, derivative by wales.
Smooth row_depth(int left, int here, int right, double from_centre) {
  const int other = from_centre > 0 ? right : left;
  const double beyond = std::abs(from_centre) - 0.5;
  const Smooth share = smooth_step((beyond + blend_width) / (2 * blend_width));
  const double slope = share.slope / (2 * blend_width) * (from_centre > 0 ? 1 : -1);
  return {-(here + share.value * (other - here)), -slope * (other - here)};
}

}  // namespace

Curve3 chain_point(const ChainSize& chain, const LoopSize& size, int left_sign, int here_sign, int right_sign,
                   double centre, double x) {
  const double wale = size.wale(), k = 2 * std::numbers::pi / wale;
  const Smooth depth = row_depth(left_sign, here_sign, right_sign, (x - centre) / wale);
  // Reaches into the sinkers' arches between the wales, or into the heads in the middle of each wale.
  const double inwards = chain.round_heads ? -1 : 1, start = chain.round_heads ? centre : centre + wale / 2;
  const double c = std::cos(k * (x - start)), s = std::sin(k * (x - start));
  return {{x, chain.level + inwards * chain.radius * c, size.z * depth.value - chain.radius * s},
          {1, -inwards * chain.radius * k * s, size.z * depth.slope / wale - chain.radius * k * c}};
}

}  // namespace wale
