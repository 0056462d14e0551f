#include "sim/solvers/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace wale {

namespace {

double rms(const Eigen::ArrayXd& values) {
  return std::sqrt(values.square().sum() / static_cast<double>(std::max<Eigen::Index>(1, values.size())));
}

}  // namespace

double scaled_error(const Eigen::VectorXd& y, const Eigen::VectorXd& error, const Tolerance& tolerance) {
  const Eigen::ArrayXd size = y.array().abs().max((y - error).array().abs());
  return rms(error.array() / (tolerance.absolute + tolerance.relative * size));
}

double step_factor(double scaled, int error_order) {
  if (!std::isfinite(scaled)) return 1.0 / 3;
  return std::clamp(0.9 * std::pow(scaled, -1.0 / (error_order + 1)), 1.0 / 3, 3.0);
}

StepTries::StepTries(double t, double step, double until, int error_order)
    : t_(t), step_(step), until_(until), error_order_(error_order) {}

bool StepTries::keep(double error) {
  const double proposed = (to() - t_) * std::min(largest_factor_, step_factor(error, error_order_));
  const bool kept = error <= 1;
  step_ = kept && last() ? std::max(proposed, step_) : proposed;
  largest_factor_ = 1;
  return kept;
}

void StepTries::halve() {
  step_ = (to() - t_) / 2;
  largest_factor_ = 1;
}

double first_step(const RateFunction& f, double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate, int order,
                  const Tolerance& tolerance) {
  const Eigen::ArrayXd scale = tolerance.absolute + tolerance.relative * y.array().abs();
  const double size = rms(y.array() / scale), speed = rms(rate.array() / scale);
  const double guess = size < 1e-5 || speed < 1e-5 ? 1e-6 : 0.01 * size / speed;
  Eigen::VectorXd later(y.size());
  f(t + guess, y + guess * rate, later);
  const double bend = rms((later - rate).array() / scale) / guess;
  if (!std::isfinite(bend)) return 1e-3 * guess;
  const double fastest = std::max(speed, bend);
  const double step = fastest <= 1e-15 ? std::max(1e-6, 1e-3 * guess) : std::pow(0.01 / fastest, 1.0 / (order + 1));
  return std::min(100 * guess, step);
}

}  // namespace wale
