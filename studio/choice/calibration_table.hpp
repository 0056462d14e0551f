#pragma once
#include "studio/choice/calibration.hpp"
namespace wale {
inline Calibration measured_calibration() { return {}; }
}  // namespace wale
