/// From an accuracy that is asked for to the settings that reach it at the least cost.
#pragma once

#include <optional>
#include <string>

#include "studio/accuracy/variant.hpp"
#include "studio/choice/calibration.hpp"
#include "studio/choice/scales.hpp"

namespace wale {

struct Resolution {
  double asked = 0;           ///< error of the stress over its peak
  double segment_length = 0;  ///< knitted, over the yarn's diameter
  int segments_per_stitch = 0;
  Fineness fineness{};
  int samples_times = 1;          ///< by which the samples of stages that strain are multiplied
  double friction_threshold = 0;  ///< over the speed at which a diameter is strained
  double expected = 0;            ///< error: in 9 of 10 scenes of the calibration it was less
  double cost = 0;                ///< see Calibration::costs
  int scenes = 0;                 ///< by how many that is known: those whose reference is known so well
  int refinements = 0;            ///< see refined()

  bool reached() const { return expected <= asked; }
};

/// The cheapest of all that are expected to be off by no more than two thirds of `asked`, as scenes are more various
/// than those of a calibration; if there are none, that of the least error. Between segments that were measured errors
/// and costs are taken to be powers. `strain_a_sample` is that of the scene as written; 0 if nothing is strained.
Resolution choose_resolution(double asked, const Scales&, double strain_a_sample,
                             const Calibration& = shipped_calibration());

/// Five quarters of the segments and twice the samples, for a scene that turned out harder than those of the
/// calibration.
Resolution refined(Resolution);

/// The scene compiled with these settings in place of its own.
Variant variant_of(const Resolution&);

/// Lines that say what was chosen and why; `written` is the number of segments that the file asks for.
std::string words_of(const Resolution&, int written);

}  // namespace wale
