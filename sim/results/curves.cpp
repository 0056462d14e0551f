#include "sim/results/curves.hpp"

#include <algorithm>
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

std::vector<double> column(const Table& table, std::string_view name, const std::vector<std::size_t>& rows) {
  const Column* found = table.find(name);
  std::vector<double> values;
  for (const std::size_t row : rows) values.push_back(found ? found->values[row] : unknown);
  return values;
}

}  // namespace

std::vector<std::size_t> pulled_rows(const Table& table) {
  const Column *strain = table.find("strain"), *stage = table.find("stage");
  std::vector<std::size_t> rows;
  if (!strain) return rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (std::isnan(strain->values[row])) continue;
    if (stage && !rows.empty() && stage->values[row] != stage->values[rows.back()]) rows.clear();
    rows.push_back(row);
  }
  return rows;
}

Curve stress_strain(const Results& results) {
  const Table& table = results.samples;
  const std::vector<std::size_t> rows = pulled_rows(table);
  return {column(table, "strain", rows), column(table, "stress", rows), column(table, "force", rows),
          column(table, "force_per_wale", rows)};
}

Features features(const Curve& curve) {
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < curve.strain.size(); ++i)
    if (std::isfinite(curve.strain[i]) && std::isfinite(curve.stress[i]))
      samples.push_back({curve.strain[i], curve.stress[i]});
  if (samples.size() < 2) return {unknown, unknown, unknown};
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Sample& a, const Sample& b) { return a.strain < b.strain; });
  const double from = samples.front().strain, to = samples.back().strain;
  const double part = std::min(0.10, (to - from) / 3);
  const Line first = fit_start(samples, part);
  std::reverse(samples.begin(), samples.end());
  const Line last = fit_start(samples, part);
  const double crossing = (first.offset - last.offset) / (last.slope - first.slope);
  return {first.slope, crossing >= from && crossing <= to ? crossing : unknown, last.slope};
}

}  // namespace wale
