/// How large a time step may be: a first guess, and the tries by whose errors it is found.
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

/// The tries at one step, each shorter than the one before, until the error of one is at most 1.
class StepTries {
 public:
  /// From time `t`, the first try `step` long, with an error estimate of order `error_order`. None passes `until`.
  StepTries(double t, double step, double until, int error_order);

  /// Where the next try ends. One that would leave less than a hundredth of itself before `until` goes all the way.
  double to() const { return last() ? until_ : t_ + step_; }
  /// Whether the next try is that short; the way that is left to `until` may always be.
  bool shorter_than(double least) const { return !last() && step_ <= least; }

  /// After a try with this scaled error: whether it may be kept.
  bool keep(double error);
  /// After a try that found no step at all.
  void halve();
  /// What the error control wants next; where `until` cut the kept try short, it is not the cut step.
  double step() const { return step_; }

 private:
  bool last() const { return t_ + 1.01 * step_ >= until_; }

  double t_, step_, until_;
  int error_order_;
  double largest_factor_ = 3;  // a step does not grow straight after a try that failed
};

/// A first step from `y`, where f is `rate`, for a method of this order; one evaluation (ibid., "starting step size").
double first_step(const RateFunction& f, double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate, int order,
                  const Tolerance&);

}  // namespace wale
