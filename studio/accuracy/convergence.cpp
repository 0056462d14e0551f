#include "studio/accuracy/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wale {

double observed_order(double h1, double h2, double h3, double difference_12, double difference_23) {
  constexpr double least = 0.2, most = 8;
  const double ratio = difference_12 / difference_23;
  const auto excess = [&](double p) {
    return (std::pow(h1, p) - std::pow(h2, p)) / (std::pow(h2, p) - std::pow(h3, p)) - ratio;
  };
  double low = least, high = most;
  // The quotient grows with p, so that one root at most is enclosed.
  if (!(excess(low) < 0) || !(excess(high) > 0)) return std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (excess(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

double error_left(double h1, double h2, double difference, double order) {
  return difference / (std::pow(h1 / h2, order) - 1);
}

std::vector<std::size_t> pareto_front(const std::vector<WorkPrecision>& runs) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (std::isfinite(runs[i].seconds) && std::isfinite(runs[i].error)) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return runs[a].seconds != runs[b].seconds ? runs[a].seconds < runs[b].seconds : runs[a].error < runs[b].error;
  });
  double least = std::numeric_limits<double>::infinity();
  std::erase_if(order, [&](std::size_t i) {
    if (!(runs[i].error < least)) return true;
    least = runs[i].error;
    return false;
  });
  return order;
}

}  // namespace wale
