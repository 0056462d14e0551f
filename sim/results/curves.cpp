#include "sim/results/curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wale {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Line {
  double offset = unknown, slope = unknown;
};

struct Sample {
  double strain = 0, stress = 0;
};

Line fit(const std::vector<Sample>& samples) {
  const double n = static_cast<double>(samples.size());
  double strain = 0, stress = 0, square = 0, product = 0;
  for (const Sample& at : samples) strain += at.strain / n, stress += at.stress / n;
  for (const Sample& at : samples) {
    square += (at.strain - strain) * (at.strain - strain);
    product += (at.strain - strain) * (at.stress - stress);
  }
  if (!(square > 0)) return {};
  return {stress - product / square * strain, product / square};
}

/// A line through the first samples that lie within `part` of the first, at least two.
Line fit_start(const std::vector<Sample>& samples, double part) {
  const double start = samples.front().strain;
  std::vector<Sample> taken;
  for (const Sample& at : samples)
    if (taken.size() < 2 || std::abs(at.strain - start) <= part * (1 + 1e-9)) taken.push_back(at);
  return fit(taken);
}

/// Until the strain first turns back; rounding is no turn.
std::vector<Sample> first_branch(const std::vector<Sample>& samples) {
  constexpr double turn = 1e-9;
  std::size_t last = 0;
  while (last + 1 < samples.size()) {
    const double way = samples[last].strain - samples.front().strain;
    const double step = samples[last + 1].strain - samples[last].strain;
    if (std::abs(step) > turn && way * step < 0) break;
    ++last;
  }
  return {samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(std::min(last + 1, samples.size()))};
}

std::vector<double> column(const Table& table, std::string_view name, const std::vector<std::size_t>& rows) {
  const Column* found = table.find(name);
  std::vector<double> values;
  for (const std::size_t row : rows) values.push_back(found ? found->values[row] : unknown);
  return values;
}

constexpr std::array parts{"wale", "course", "shear"};

std::string strain_of_part(const char* part) { return std::string("strain.") + part; }

double value(const Table& table, std::string_view name, std::size_t row) {
  const Column* found = table.find(name);
  return found ? found->values[row] : unknown;
}

/// The strain of a pull, or the root of squares of those of a deformation; unknown in a stage without.
double strain_in(const Table& table, std::size_t row) {
  const double pulled = value(table, "strain", row);
  if (!std::isnan(pulled)) return pulled;
  double square = 0;
  for (const char* part : parts) square += std::pow(value(table, strain_of_part(part), row), 2);
  return std::sqrt(square);
}

}  // namespace

std::vector<std::size_t> strained_rows(const Table& table) {
  const Column* stage = table.find("stage");
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (std::isnan(strain_in(table, row))) continue;
    if (stage && !rows.empty() && stage->values[row] != stage->values[rows.back()]) rows.clear();
    rows.push_back(row);
  }
  return rows;
}

std::optional<std::size_t> most_strained_row(const Table& table) {
  std::optional<std::size_t> most;
  for (const std::size_t row : strained_rows(table))
    if (!most || strain_in(table, row) >= strain_in(table, *most)) most = row;
  return most;
}

Curve stress_strain(const Results& results) {
  const Table& table = results.samples;
  std::vector<std::size_t> rows = strained_rows(table);
  std::erase_if(rows, [&](std::size_t row) { return std::isnan(value(table, "strain", row)); });
  return {column(table, "strain", rows), column(table, "stress", rows), column(table, "force", rows),
          column(table, "force_per_wale", rows)};
}

std::vector<LabelledCurve> stress_strain_curves(const Results& results) {
  Curve pulled = stress_strain(results);
  if (!pulled.strain.empty()) return {{"", std::move(pulled)}};
  const Table& table = results.samples;
  const std::vector<std::size_t> rows = strained_rows(table);
  std::vector<LabelledCurve> curves;
  if (rows.empty()) return curves;
  for (const char* part : parts)
    curves.push_back({part,
                      {.strain = column(table, strain_of_part(part), rows),
                       .stress = column(table, std::string("stress.") + part, rows),
                       .force = {},
                       .force_per_wale = {}}});
  return curves;
}

Features features(const Curve& curve) {
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < curve.strain.size(); ++i)
    if (std::isfinite(curve.strain[i]) && std::isfinite(curve.stress[i]))
      samples.push_back({curve.strain[i], curve.stress[i]});
  if (samples.size() < 2) return {unknown, unknown, unknown};
  samples = first_branch(samples);
  const double from = samples.front().strain, to = samples.back().strain;
  const double part = std::min(0.10, std::abs(to - from) / 3);
  const Line first = fit_start(samples, part);
  std::reverse(samples.begin(), samples.end());
  const Line last = fit_start(samples, part);
  const double crossing = (first.offset - last.offset) / (last.slope - first.slope);
  const bool is_within = std::min(from, to) <= crossing && crossing <= std::max(from, to);
  return {first.slope, is_within ? crossing : unknown, last.slope};
}

}  // namespace wale
