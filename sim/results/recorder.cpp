#include "sim/results/recorder.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace wale {
namespace {

constexpr double lacking = std::numeric_limits<double>::quiet_NaN();

Column& column_for(Table& table, const Quantity& quantity, std::size_t rows) {
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& column) { return column.name == quantity.name; });
  if (found == table.columns.end())
    return table.columns.emplace_back(Column{quantity.name, quantity.unit, std::vector<double>(rows, lacking)});
  if (found->unit != quantity.unit)
    throw std::invalid_argument("column " + quantity.name + " holds " + found->unit + ", not " + quantity.unit);
  return *found;
}

}  // namespace

void append_row(Table& table, const std::vector<Quantity>& row) {
  const std::size_t rows = table.rows();
  for (const Quantity& quantity : row) {
    Column& column = column_for(table, quantity, rows);
    if (column.values.size() != rows) throw std::invalid_argument("two values for column " + quantity.name);
    column.values.push_back(quantity.value);
  }
  for (Column& column : table.columns) column.values.resize(rows + 1, lacking);
}

}  // namespace wale
