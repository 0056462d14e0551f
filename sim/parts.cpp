#include "sim/parts.hpp"

#include "sim/effects/beads.hpp"

namespace wale {

std::shared_ptr<Beads> Parts::beads(double sampling, double screening, double skin) {
  auto& made = made_beads[{sampling, screening, skin}];
  if (!made) made = std::make_shared<Beads>(fabric, sampling, screening, skin);
  return made;
}

std::shared_ptr<Beads> Parts::dissipative_beads(double sampling, double screening, double skin) {
  if (!lagged) return beads(sampling, screening, skin);
  auto& made = made_lagged_beads[{sampling, screening, skin}];
  if (!made) made = std::make_shared<Beads>(fabric, sampling, screening, skin);
  return made;
}

}  // namespace wale
