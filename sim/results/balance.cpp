#include "sim/results/balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace wale {
namespace {

/// The largest amount of a column in a stage; 0 if it is nowhere known.
double largest(const Table& table, std::string_view name, std::size_t stage) {
  const Column *column = table.find(name), *stages = table.find("stage");
  double most = 0;
  for (std::size_t row = 0; column && stages && row < table.rows(); ++row)
    if (stages->values[row] == static_cast<double>(stage)) most = std::fmax(most, std::abs(column->values[row]));
  return most;
}

/// A deformation has no one load, but a stress for each period: the force on a wale or course that goes with it.
void note_load_of_deform(const Results& results, std::size_t stage, Balance& balance) {
  const Gauge& gauge = results.scene.gauge;
  const double wale_section = results.relaxed.width * gauge.thickness / gauge.wales,
               course_section = results.relaxed.length * gauge.thickness / gauge.courses;
  const auto stress = [&](const char* name) { return largest(results.samples, name, stage); };
  const double on_wale = wale_section * std::max(stress("stress.wale"), stress("stress.shear")),
               on_course = course_section * stress("stress.course");
  balance.along = on_course > on_wale ? Along::course : Along::wale;
  balance.load = std::max(on_wale, on_course);
}

}  // namespace

double Balance::share() const { return load > 0 ? residual / load : std::numeric_limits<double>::quiet_NaN(); }

std::vector<Balance> balances(const Results& results) {
  std::vector<Balance> all;
  for (std::size_t i = 0; i < results.scene.stages.size(); ++i) {
    const Stage& stage = results.scene.stages[i];
    const QuasiStatic* spec = std::get_if<QuasiStatic>(&stage.solver);
    const double residual = largest(results.samples, "residual", i);
    if (!spec || residual == 0) continue;
    Balance balance{stage.name, residual, allowed_residual(*spec, results.scene.fabric)};
    if (stage.pull) {
      balance.along = stage.pull->along;
      balance.load = largest(results.samples, "force_per_wale", i);
    }
    const bool only_bends = stage.deform && stage.strains() && stage.deform->leaves_periods_free();
    if (stage.deform && !only_bends) note_load_of_deform(results, i, balance);
    all.push_back(std::move(balance));
  }
  return all;
}

}  // namespace wale
