/// Gathers the rows of a results table, whatever each stage has to tell.
#pragma once

#include <string>
#include <vector>

#include "sim/results/results.hpp"

namespace wale {

/// One number of a row: "energy.bend", "J".
struct Quantity {
  std::string name, unit;
  double value = 0;
};

/// Adds one row. A quantity without a column makes one, with NaN in the earlier rows; a column without a quantity
/// gets NaN in this row. Throws std::invalid_argument if a name comes twice, or with another unit than its column's.
void append_row(Table&, const std::vector<Quantity>&);

}  // namespace wale
