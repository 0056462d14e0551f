/// How errors fall: orders, limits, and which of several runs are worth their time.
#pragma once

#include <cstddef>
#include <vector>

namespace wale {

/// p of answers A + C h^p, from the differences between those at sizes h1 > h2 > h3 (Richardson). NaN unless it lies
/// between 0.2 and 8.
double observed_order(double h1, double h2, double h3, double difference_12, double difference_23);

/// The error left at size h2, if answers at h1 > h2 differ by `difference` and errors fall with that order.
double error_left(double h1, double h2, double difference, double order);

struct WorkPrecision {
  double seconds = 0, error = 0;
};
/// Those to which none other is both faster and more accurate, by increasing time. Entries that are not finite are
/// none.
std::vector<std::size_t> pareto_front(const std::vector<WorkPrecision>&);

}  // namespace wale
