/// What a scene or a command line may ask of a knitout file.
#pragma once

#include "compiler/crop.hpp"
#include "compiler/program.hpp"
#include "compiler/stitch_lengths.hpp"

namespace wale {

struct KnitoutOptions {
  Crop crop;
  StitchLengths stitch_lengths;  ///< where they differ from what is assumed
  Plating plating = Plating::first_in_front;
};

}  // namespace wale
