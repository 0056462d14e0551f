/// The force kernels, compiled once for every instruction set.
#pragma once

#include "sim/effects/bend_law.hpp"
#include "sim/effects/drag_law.hpp"
#include "sim/effects/gravity_law.hpp"
#include "sim/effects/obstacle_law.hpp"
#include "sim/effects/plates_law.hpp"
#include "sim/effects/stretch_law.hpp"
#include "sim/effects/tether_law.hpp"
#include "sim/kernels/along_yarn_block.hpp"
#include "sim/kernels/bead_kernels.hpp"
#include "sim/kernels/instruction_set.hpp"

namespace wale {

template <class L>
struct AlongEntry {
  AlongKernel<L> kernel;
};

/// A table for one instruction set.
struct Kernels : AlongEntry<StretchLaw>,
                 AlongEntry<BendLaw>,
                 AlongEntry<SetBendLaw>,
                 AlongEntry<GravityLaw>,
                 AlongEntry<DragLaw>,
                 AlongEntry<PlatesLaw>,
                 AlongEntry<TetherLaw>,
                 AlongEntry<ObstacleLaw> {
  BeadKernels beads;

  template <class L>
  AlongKernel<L> along() const {
    return static_cast<const AlongEntry<L>&>(*this).kernel;
  }
};

/// The table for instruction_set().
const Kernels& kernels();
/// The table for another set; it must be supported.
const Kernels& kernels(InstructionSet);

}  // namespace wale
