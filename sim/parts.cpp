#include "sim/parts.hpp"

#include "sim/effects/beads.hpp"

namespace wale {

std::shared_ptr<Beads> Parts::beads(double sampling, double screening) {
  auto& made = made_beads[{sampling, screening}];
  if (!made) made = std::make_shared<Beads>(fabric, sampling, screening);
  return made;
}

std::shared_ptr<Beads> Parts::dissipative_beads(double sampling, double screening) {
  if (!lagged) return beads(sampling, screening);
  auto& made = made_lagged_beads[{sampling, screening}];
  if (!made) made = std::make_shared<Beads>(fabric, sampling, screening);
  return made;
}

}  // namespace wale
