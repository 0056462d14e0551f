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

bool is_known(const Column& column, const std::vector<std::size_t>& rows) {
  return std::any_of(rows.begin(), rows.end(), [&](std::size_t row) { return !std::isnan(column.values[row]); });
}

/// A stage that deforms has strains and stresses by direction, and no one strain, stress and force.
std::vector<Printed> printed_columns(const Table& table, const std::vector<std::size_t>& rows) {
  std::vector<Printed> columns;
  const Column* strain = table.find("strain");
  if (rows.empty() || (strain && is_known(*strain, rows)))
    columns = {{"strain", strain},
               {"stress_MPa", table.find("stress"), 1e-6},
               {"force_N", table.find("force")},
               {"force_per_wale_N", table.find("force_per_wale")}};
  for (const char* part : {"wale", "course", "shear"}) {
    const std::string name = part;
    const Column *of_strain = table.find("strain." + name), *of_stress = table.find("stress." + name);
    if (of_strain && is_known(*of_strain, rows)) columns.push_back({"strain_" + name, of_strain});
    if (of_stress && is_known(*of_stress, rows)) columns.push_back({"stress_" + name + "_MPa", of_stress, 1e-6});
  }
  if (const Column* residual = table.find("residual"); residual && is_known(*residual, rows))
    columns.push_back({"residual_N", residual});
  for (const Column& column : table.columns)
    if (column.name.starts_with("energy.") && is_known(column, rows)) columns.push_back({plain_name(column), &column});
  return columns;
}

}  // namespace

std::string curve_csv(const Results& results) {
  const std::vector<std::size_t> rows = strained_rows(results.samples);
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
