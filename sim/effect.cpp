#include "sim/effect.hpp"

#include <limits>

namespace wale {

double Effect::closest() const { return std::numeric_limits<double>::infinity(); }

}  // namespace wale
