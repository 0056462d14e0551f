/// Fills a table of kernels. `Wide` is the number type that runs over segments and pushes beads, `Four` the one of all
/// else on beads.
#pragma once

#include "sim/kernels/along_yarn_kernel.hpp"
#include "sim/kernels/bead_kernels_of.hpp"
#include "sim/kernels/bead_push_kernel.hpp"
#include "sim/kernels/tables.hpp"

namespace wale {

template <class Wide, class Four>
inline constexpr Kernels kernels_of{
    {&AlongYarnKernel<Wide, StretchLaw>::add},
    {&AlongYarnKernel<Wide, BendLaw>::add},
    {&AlongYarnKernel<Wide, SetBendLaw>::add},
    {&AlongYarnKernel<Wide, GravityLaw>::add},
    {&AlongYarnKernel<Wide, DragLaw>::add},
    {&AlongYarnKernel<Wide, PlatesLaw>::add},
    {&AlongYarnKernel<Wide, TetherLaw>::add},
    {&AlongYarnKernel<Wide, ObstacleLaw>::add},
    {&AnyBeadKernels<Four>::locate, &AnyBeadKernels<Four>::measure, &push_beads<Wide>, &AnyBeadKernels<Four>::spread}};

}  // namespace wale
