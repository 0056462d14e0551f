/// How large a time step may be: the error of the last one, and a first guess.
#pragma once

#include "sim/solvers/explicit_stepper.hpp"

namespace wale {

struct Tolerance {
  double relative = 1e-4, absolute = 1e-8;
};

/// The root mean square of error / (absolute + relative max(|y|, |y - error|)): at most 1 for a step that may be kept.
double scaled_error(const Eigen::VectorXd& y, const Eigen::VectorXd& error, const Tolerance&);

/// What to multiply a step by after an error of `scaled`: 0.9 scaled^(-1/(error_order + 1)), within 1/3 ... 3; 1/3
/// if `scaled` is not a number (Hairer, Nørsett & Wanner I, II.4).
double step_factor(double scaled, int error_order);

/// A first step from `y`, where f is `rate`, for a method of this order; one evaluation (ibid., "starting step size").
double first_step(const RateFunction& f, double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate, int order,
                  const Tolerance&);

}  // namespace wale
