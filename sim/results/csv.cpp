#include "sim/results/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "sim/results/curves.hpp"
#include "sim/results/file.hpp"

namespace wale {
namespace {

struct Printed {
  std::string name;
  const Column* column = nullptr;  // null: nan throughout
  double scale = 1;
};

/// "energy.grip.top" in J is energy_grip_top_J.
std::string plain_name(const Column& column) {
  std::string name = column.name;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name + "_" + column.unit;
}

std::vector<Printed> printed_columns(const Table& table, const std::vector<std::size_t>& rows) {
  std::vector<Printed> columns{{"strain", table.find("strain")},
                               {"stress_MPa", table.find("stress"), 1e-6},
                               {"force_N", table.find("force")},
                               {"force_per_wale_N", table.find("force_per_wale")}};
  for (const Column& column : table.columns) {
    const bool is_known =
        std::any_of(rows.begin(), rows.end(), [&](std::size_t row) { return !std::isnan(column.values[row]); });
    if (column.name.starts_with("energy.") && is_known) columns.push_back({plain_name(column), &column});
  }
  return columns;
}

}  // namespace

std::string curve_csv(const Results& results) {
  const std::vector<std::size_t> rows = pulled_rows(results.samples);
  const std::vector<Printed> columns = printed_columns(results.samples, rows);
  std::string text;
  for (const Printed& column : columns) text += (text.empty() ? "" : ",") + column.name;
  text += "\n";
  for (const std::size_t row : rows) {
    const char* between = "";
    for (const Printed& printed : columns) {
      const double value =
          printed.column ? printed.scale * printed.column->values[row] : std::numeric_limits<double>::quiet_NaN();
      text += std::isnan(value) ? fmt::format("{}nan", between) : fmt::format("{}{:.9g}", between, value);
      between = ",";
    }
    text += "\n";
  }
  return text;
}

void write_csv(const Results& results, const std::string& path) { write_file(path, curve_csv(results)); }

}  // namespace wale
