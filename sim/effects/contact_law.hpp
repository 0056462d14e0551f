/// The three laws by which yarns push each other apart, and their slopes.
#pragma once

#include "sim/fabric.hpp"

namespace wale {

struct Penalty {
  double value = 0, first = 0, second = 0;  ///< f, f', f'' by δ, N/m
};

/// f(δ), with δ the distance over the contact diameter; zero for δ ≥ 1. Infinite at δ ≤ 0 for the barrier,
/// at or inside the core for the core-shell law.
Penalty penalty(const Material&, double delta);
/// Two yarns share the push: the mean of both laws.
Penalty penalty(const Material& a, const Material& b, double delta);

}  // namespace wale
