/// Fills a table of kernels, which run on one number type.
#pragma once

#include "sim/kernels/along_yarn_kernel.hpp"
#include "sim/kernels/bead_kernels_of.hpp"
#include "sim/kernels/tables.hpp"

namespace wale {

template <class Real>
inline constexpr Kernels kernels_of{{&AlongYarnKernel<Real, StretchLaw>::add},
                                    {&AlongYarnKernel<Real, BendLaw>::add},
                                    {&AlongYarnKernel<Real, SetBendLaw>::add},
                                    {&AlongYarnKernel<Real, GravityLaw>::add},
                                    {&AlongYarnKernel<Real, DragLaw>::add},
                                    {&AlongYarnKernel<Real, PlatesLaw>::add},
                                    {&AlongYarnKernel<Real, TetherLaw>::add},
                                    {&AlongYarnKernel<Real, ObstacleLaw>::add},
                                    {&BeadKernelsOf<Real>::locate, &BeadKernelsOf<Real>::measure,
                                     &BeadKernelsOf<Real>::push, &BeadKernelsOf<Real>::spread}};

}  // namespace wale
