/// One explicit Runge-Kutta step at a time for y' = f(t, y), to be accepted or not.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "sim/solvers/tableaux.hpp"

namespace wale {

/// rate := f(t, y), of the size of y.
using RateFunction = std::function<void(double t, const Eigen::VectorXd& y, Eigen::VectorXd& rate)>;

class ExplicitStepper {
 public:
  /// `tableau` must outlive the stepper. Evaluates f once.
  ExplicitStepper(const Tableau& tableau, RateFunction f, double t, Eigen::VectorXd y);

  double t() const { return t_; }
  const Eigen::VectorXd& y() const { return y_; }
  /// f(t, y).
  const Eigen::VectorXd& rate() const { return stages_.front(); }

  /// Computes the step from t() to `to`; t() and y() stay until it is accepted.
  void attempt(double to);
  const Eigen::VectorXd& attempted() const { return next_; }
  /// attempted() less the embedded solution.
  const Eigen::VectorXd& error() const { return error_; }
  void accept();

  /// Between the ends of the last accepted step by Hermite's cubic and what the tableau adds to it; `t` outside it
  /// gives its nearer end.
  Eigen::VectorXd at(double t) const;

 private:
  const Tableau& tableau_;
  RateFunction f_;
  double t_, next_t_, last_t_;
  Eigen::VectorXd y_, next_, error_, last_y_, last_rate_, bulge_;  // bulge_: h Σ dense_i k_i
  std::vector<Eigen::VectorXd> stages_;
};

}  // namespace wale
