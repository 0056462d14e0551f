/// How a stage strains a fabric, by time.
#pragma once

#include <vector>

#include "sim/scene.hpp"

namespace wale {

/// The strain of a pull: from 0 at t = 0 through its strains in turn at constant speed, to the last at t = `duration`,
/// s.
Schedule strain_of(const Pull&, double duration);

/// The strain of a driven `part` of `deform`. All parts reach their n-th strains at the same time; the point of the
/// three strains moves at constant speed, so that each leg takes its share of the whole way, and the curvature goes
/// along; alone it takes as long for each of its own. Of the curl it is the curvature, 1/m, as if that began at 0.
Schedule strain_of(const Deform& deform, const Deform::Part& part, double duration);

/// Times at which the strains of a stage turn, and at its end, s; nothing if it is not strained.
std::vector<double> turns_of(const Stage&);

/// What a stage does to the periods of a periodic fabric: what it says, or else what its pull means (that direction
/// driven, all else free), or that it holds them; without any of these they are free.
Deform deform_of(const Stage&);

}  // namespace wale
