/// Fills a table of kernels. `Wide` is the number type that runs over segments, `Four` the one that runs over four
/// beads.
#pragma once

#include "sim/kernels/along_yarn_kernel.hpp"
#include "sim/kernels/bead_kernels_of.hpp"
#include "sim/kernels/tables.hpp"

namespace wale {

template <class Wide, class Four>
inline constexpr Kernels kernels_of{{&AlongYarnKernel<Wide, StretchLaw>::add},
                                    {&AlongYarnKernel<Wide, BendLaw>::add},
                                    {&AlongYarnKernel<Wide, SetBendLaw>::add},
                                    {&AlongYarnKernel<Wide, GravityLaw>::add},
                                    {&AlongYarnKernel<Wide, DragLaw>::add},
                                    {&AlongYarnKernel<Wide, PlatesLaw>::add},
                                    {&AlongYarnKernel<Wide, TetherLaw>::add},
                                    {&AlongYarnKernel<Wide, ObstacleLaw>::add},
                                    {&BeadKernelsOf<Four>::locate, &BeadKernelsOf<Four>::measure,
                                     &BeadKernelsOf<Four>::push, &BeadKernelsOf<Four>::spread}};

}  // namespace wale
