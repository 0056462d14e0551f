/// How often one piece of yarn twists round another, seen from one side.
#pragma once

#include "sim/fabric.hpp"

namespace wale {

/// The sum of the signs of the crossings of two polylines (3 x n and 3 x m, m) seen along `along`: +1 where the upper
/// must turn counter-clockwise to lie along the lower, -1 else. It does not depend on which side one looks from, and
/// stays when the two are pushed about without passing through each other, as long as no end of one passes the other.
/// A loop's side that is pulled through another loop crosses it twice with the same sign.
int net_crossing(const Points& a, const Points& b, const Vec3& along);

/// The mean of that over directions spread evenly over the sphere, twice Gauss's linking integral of the two pieces:
/// near 2 or -2 where they clasp, near 0 where they do not.
double mean_net_crossing(const Points& a, const Points& b);

/// How often the first of two polylines passes before the second, and how often behind it, seen along `along`.
struct Passing {
  int before = 0, behind = 0;
};
Passing passing(const Points& a, const Points& b, const Vec3& along);

/// The loop's area vector ½ Σ a x b, closed by its chord: the side from which a loop is seen widest, m².
Vec3 area_vector(const Points& loop);

}  // namespace wale
