#include "sim/solvers/explicit_stepper.hpp"

#include <algorithm>
#include <utility>

#include "sim/solvers/hermite.hpp"

namespace wale {

namespace {

/// h Σ weight_i k_i, of the size of `sum`.
void combine(double h, const std::vector<double>& weights, const std::vector<Eigen::VectorXd>& stages,
             Eigen::VectorXd& sum) {
  sum.setZero();
  for (std::size_t i = 0; i < weights.size(); ++i) sum += (h * weights[i]) * stages[i];
}

}  // namespace

ExplicitStepper::ExplicitStepper(const Tableau& tableau, RateFunction f, double t, Eigen::VectorXd y)
    : tableau_(tableau), f_(std::move(f)), t_(t), next_t_(t), last_t_(t), y_(std::move(y)), next_(y_), last_y_(y_) {
  stages_.assign(tableau.c.size(), Eigen::VectorXd::Zero(y_.size()));
  error_ = bulge_ = stages_.front();
  f_(t_, y_, stages_.front());
  last_rate_ = stages_.front();
}

void ExplicitStepper::attempt(double to) {
  const double h = to - t_;
  next_t_ = to;
  for (std::size_t i = 1; i < stages_.size(); ++i) {
    next_ = y_;
    for (std::size_t j = 0; j < tableau_.a[i].size(); ++j) next_ += (h * tableau_.a[i][j]) * stages_[j];
    // The last stage opens the next step, so its time must be that step's to the last bit.
    f_(tableau_.c[i] == 1 ? to : t_ + tableau_.c[i] * h, next_, stages_[i]);
  }
  combine(h, tableau_.error, stages_, error_);
}

void ExplicitStepper::accept() {
  last_t_ = t_;
  last_y_ = y_;
  last_rate_ = stages_.front();
  combine(next_t_ - t_, tableau_.dense, stages_, bulge_);
  t_ = next_t_;
  y_ = next_;
  stages_.front() = stages_.back();
}

Eigen::VectorXd ExplicitStepper::at(double t) const {
  const double h = t_ - last_t_;
  if (h <= 0 || t >= t_) return y_;
  const double s = std::max(0.0, (t - last_t_) / h), bulging = s * s * (1 - s) * (1 - s);
  const HermiteWeights w = hermite(s, h);
  return w.first * last_y_ + w.last * y_ + w.first_rate * last_rate_ + w.last_rate * rate() + bulging * bulge_;
}

}  // namespace wale
