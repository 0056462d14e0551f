/// What each knob costs and how far it is off, as measured on many scenes: from it wale chooses knobs by itself.
#pragma once

#include <span>

namespace wale {

/// One value of a knob.
struct Calibrated {
  double value = 0;
  double error = 0;  ///< of the stress over its peak: in 9 of 10 scenes it is less
  double cost = 0;   ///< processor time over that of the scene as written; the median
};

/// By knob, from coarse to fine.
struct Calibration {
  std::span<const Calibrated> segment_length;      ///< knitted, over the yarn's diameter
  std::span<const Calibrated> sampling;            ///< Contact::sampling
  std::span<const Calibrated> tolerance;           ///< QuasiStatic::of_load of a pull, with `tolerance` half of it
  std::span<const Calibrated> load_step;           ///< strain a sample
  std::span<const Calibrated> friction_threshold;  ///< over the speed at which a diameter is strained
};

/// That measured by bench/accuracy/calibrate.cpp.
const Calibration& shipped_calibration();

}  // namespace wale
