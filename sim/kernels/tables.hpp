/// The tables of kernels, each defined in a file of its own that is compiled for its instruction set.
#pragma once

#include "sim/kernels/kernels.hpp"

namespace wale {

extern const Kernels scalar_kernels, avx2_kernels, avx512_kernels;

}  // namespace wale
