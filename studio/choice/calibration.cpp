#include "studio/choice/calibration.hpp"

#include "studio/choice/calibration_table.hpp"

namespace wale {

const Calibration& shipped_calibration() {
  static const Calibration calibration = measured_calibration();
  return calibration;
}

}  // namespace wale
