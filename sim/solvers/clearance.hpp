/// How near the axes of yarns are to each other, where their beads come so near that they could slip between.
#pragma once

#include "sim/effect.hpp"

namespace wale {

/// The contact diameter of the thinnest yarn, m.
double thinnest_diameter(const Fabric&);

/// The distance between the axes of two segments, each taken as four chords, m. `q` has the columns of State::q.
double axis_distance(const Fabric&, const Points& q, const Gap&);

/// The least distance of two axes over their contact diameter, among `gaps` of which the beads are nearer than half of
/// that; else a half.
double clearance(const Fabric&, const Points& q, const std::vector<Gap>& gaps);

/// The least distance of the axes of two yarns that a solver lets them come to, over their contact diameter: beads are
/// samples, between which yarns may slip.
inline constexpr double least_clearance = 0.1;

/// Of the pairs among `gaps`, which are those at `after`, the first segment of one whose axes are nearer than that and
/// have come nearer since `before`; -1 if there is none. The quadratic law lets yarns pass, and they may.
int about_to_pass(const Fabric&, const Points& before, const Points& after, const std::vector<Gap>& gaps);

}  // namespace wale
