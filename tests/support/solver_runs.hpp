/// Drives a solver, and compares the states that it comes to.
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>

#include "sim/solver.hpp"

namespace wale {

inline State run_to(Solver& solver, double until) {
  while (solver.state().t < until)
    if (solver.advance(until) == Progress::failed) throw std::runtime_error(solver.effort().failure);
  return solver.state();
}

inline void expect_same_bits(const State& a, const State& b) {
  EXPECT_EQ(a.t, b.t);
  EXPECT_EQ(a.q, b.q);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.step, b.step);
}

}  // namespace wale
