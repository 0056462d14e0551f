/// Taking up slack: how a fabric between two grips comes to the length at which it neither pulls nor pushes.
#pragma once

#include <vector>

namespace wale {

/// Grips stood `travel` further apart than when they closed, and read `force` once the fabric had come to rest.
struct Mounted {
  double travel = 0;  ///< m
  double force = 0;   ///< N, positive where the fabric pulls
};

/// Where the grips go next, m: by secants, within the nearest pair of a pull and a push once there is one, and never
/// further than 2 % of `gauge_length` at a time. First they stay where they closed, and then where they read no more
/// than `unread`, N: with friction, to look further for less would pull the fabric to and fro. As ISO 13934-1 mounts a
/// strip without pretension.
double next_travel(const std::vector<Mounted>& tried, double gauge_length, double unread = 0);

}  // namespace wale
