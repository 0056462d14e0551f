/// The same problem by every method, as tables of error against cost.
#pragma once

#include <string>

#include "bench/peers/problem.hpp"

namespace wale::peers {

/// The motion over the first `span` s. Errors are against Dormand-Prince at a tolerance of 1e-8.
void compare_motion(const Problem&, const std::string& title, double span);

/// The rest positions up to the end of the stage, in `samples` load steps at least. Errors are against `quasi_static`
/// at a tolerance of 0.01, or at 0.02 or 0.05 where that is not found. Implicit motion under drag is among the methods:
/// it comes to rest as well.
void compare_rest(const Problem&, const std::string& title, int samples);
/// The curve over `samples` even load steps, each begun where the one before ended. Its error is the largest difference
/// at a sample from `quasi_static` at a tolerance of 1e-5, over the largest value; whether the curve ends at a least or
/// at a saddle is said as well.
void compare_curves(const Problem&, const std::string& title, int samples);

}  // namespace wale::peers
