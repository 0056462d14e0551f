/// Yarns laid along given lines: hooked loops, crossings, knots.
#pragma once

#include "sim/fabric.hpp"
#include "sim/scene.hpp"

namespace wale::stability {

constexpr double d = 0.524e-3;  ///< contact diameter of the default material, m
constexpr double l = 0.6e-3;    ///< about what a segment of theirs measures, m
constexpr double far_off = 1;   ///< m

/// Appends an unstretched yarn along the line through `corners` (m), which are cut off round.
void lay(Fabric& fabric, const std::vector<Vec3>& corners, int material = 0);

/// Makes each segment of a yarn as long as it lies.
void unstretch(Fabric& fabric, int yarn);

/// An empty fabric of these materials.
Fabric fabric_of(std::vector<Material> materials = {Material{}});

/// One yarn along x at z = 0, and one along y above it whose axis lies `gap` (m) higher.
Fabric crossing(double gap);

/// Two hairpins pulled through each other, the first open towards -y, the second towards +y.
Fabric hooked_loops(const Material& first = {}, const Material& second = {});

/// The first and the last `count` segments of a yarn.
std::vector<int> start_of(const Fabric&, int yarn, int count = 2);
std::vector<int> end_of(const Fabric&, int yarn, int count = 2);
/// Both.
std::vector<int> ends_of(const Fabric&, int yarn, int count = 2);

/// Far off by the way `from` the yarn's end and back to its start by the way `to`, both unit vectors.
Points round_by(const Vec3& from, const Vec3& by, const Vec3& to);

}  // namespace wale::stability
