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

/// A force that presses on an obstacle; those of grips have no such dot.
bool is_of_obstacle(const Column& column) { return column.name.starts_with("force."); }

/// Of the last stage in which an obstacle stands.
std::vector<std::size_t> pressed_rows(const Table& table) {
  const Column* stage = table.find("stage");
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; stage && row < table.rows(); ++row) {
    const bool pressed = std::any_of(table.columns.begin(), table.columns.end(), [&](const Column& column) {
      return is_of_obstacle(column) && !std::isnan(column.values[row]);
    });
    if (!pressed) continue;
    if (!rows.empty() && stage->values[rows.front()] != stage->values[row]) rows.clear();
    rows.push_back(row);
  }
  return rows;
}

/// Of the last stage of a fabric that curls.
std::vector<std::size_t> bent_rows(const Table& table) {
  const Column *stage = table.find("stage"), *curvature = table.find("curvature");
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; stage && curvature && row < table.rows(); ++row)
    if (stage->values[row] == stage->values.back()) rows.push_back(row);
  return rows;
}

/// A stage that deforms has strains and stresses by direction, and no one strain, stress and force; one that only
/// presses has its time.
std::vector<Printed> printed_columns(const Table& table, const std::vector<std::size_t>& rows) {
  std::vector<Printed> columns;
  const Column* strain = table.find("strain");
  if (rows.empty() || (strain && is_known(*strain, rows)))
    columns = {{"strain", strain},
               {"stress_MPa", table.find("stress"), 1e-6},
               {"force_N", table.find("force")},
               {"force_per_wale_N", table.find("force_per_wale")}};
  else if (strained_rows(table).empty())
    columns = {{"t_s", table.find("t")}};
  for (const char* part : {"wale", "course", "shear"}) {
    const std::string name = part;
    const Column *of_strain = table.find("strain." + name), *of_stress = table.find("stress." + name);
    if (of_strain && is_known(*of_strain, rows)) columns.push_back({"strain_" + name, of_strain});
    if (of_stress && is_known(*of_stress, rows)) columns.push_back({"stress_" + name + "_MPa", of_stress, 1e-6});
  }
  for (const auto& [name, printed] : {std::pair{"curvature", "curvature_per_m"}, std::pair{"moment", "moment_N"}})
    if (const Column* of_curl = table.find(name); of_curl && is_known(*of_curl, rows))
      columns.push_back({printed, of_curl});
  for (const Column& column : table.columns)
    if (is_of_obstacle(column) && is_known(column, rows)) columns.push_back({plain_name(column), &column});
  if (const Column* residual = table.find("residual"); residual && is_known(*residual, rows))
    columns.push_back({"residual_N", residual});
  for (const Column& column : table.columns)
    if (column.name.starts_with("energy.") && is_known(column, rows)) columns.push_back({plain_name(column), &column});
  return columns;
}

}  // namespace

std::string curve_csv(const Results& results) {
  std::vector<std::size_t> rows = strained_rows(results.samples);
  if (rows.empty()) rows = pressed_rows(results.samples);
  if (rows.empty()) rows = bent_rows(results.samples);
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
