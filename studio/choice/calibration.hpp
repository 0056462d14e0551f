/// What settings cost and how far they are off in many scenes: from it wale chooses settings by itself.
#pragma once

#include <string>
#include <vector>

namespace wale {

/// Settings but for the segments, which are told by their length.
struct Fineness {
  double sampling = 0;   ///< Contact::sampling
  double tolerance = 0;  ///< QuasiStatic::of_load of a pull, with half of it as `tolerance`
  double load_step = 0;  ///< strain a sample
};

struct Calibration {
  /// One scene that was run with so many segments a stitch and so fine, errors by Fineness and then by number.
  struct Scene {
    std::string name;
    double stitch_length = 0;                 ///< over the yarn's diameter
    double reference = 0;                     ///< how far its reference may be off itself
    std::vector<std::vector<double>> errors;  ///< of the stress over its peak; infinite where there is no answer
  };
  double friction_threshold = 0;  ///< of all runs, over the speed at which a diameter is strained
  std::vector<int> segments;      ///< a stitch, rising
  std::vector<Fineness> fineness;
  std::vector<std::vector<double>>
      costs;  ///< as errors, processor time over that of 24 segments and the first, medians
  std::vector<Scene> scenes;
};

/// Measured by bench/accuracy/calibrate.cpp.
const Calibration& shipped_calibration();

}  // namespace wale
