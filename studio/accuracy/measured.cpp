#include "studio/accuracy/measured.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/results/moments.hpp"
#include "studio/accuracy/along_yarn.hpp"

namespace wale {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr int places_a_yarn = 400;

/// Places at even shares of a yarn's knitted length, whatever its segments.
void append_places(const Fabric& fabric, const Points& q, const Yarn& yarn, Points& places, Eigen::Index& next) {
  const AlongYarn along(fabric, yarn);
  for (int i = 0; i < places_a_yarn; ++i) places.col(next++) = along.at(q, (i + 0.5) / places_a_yarn).y;
}

Points places_of(const Results& results) {
  const Snapshot* relaxed = relaxed_state(results);
  if (!relaxed) return {};
  const Fabric& fabric = results.scene.fabric;
  Points places(3, places_a_yarn * static_cast<Eigen::Index>(fabric.yarns.size()));
  Eigen::Index next = 0;
  for (const Yarn& yarn : fabric.yarns) append_places(fabric, relaxed->state.q, yarn, places, next);
  return places;
}

double elastic_energy(const Results& results) {
  const auto row = most_strained_row(results.samples);
  if (!row) return unknown;
  double sum = 0;
  for (const Column& column : results.samples.columns) {
    const bool elastic = column.name.starts_with("energy.") && column.name != "energy.kinetic";
    if (elastic && std::isfinite(column.values[*row])) sum += column.values[*row];
  }
  return sum / (results.scene.gauge.wales * results.scene.gauge.courses);
}

double relative(double a, double fine) { return std::abs(a - fine) / std::abs(fine); }

/// `curve` where `share` of the pull is done, 0 to 1.
double stress_at(const Curve& curve, double share) {
  const double at = share * static_cast<double>(curve.stress.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), curve.stress.size() - 2);
  const double part = at - static_cast<double>(below);
  return (1 - part) * curve.stress[below] + part * curve.stress[below + 1];
}

/// The largest difference of two curves and the largest stress of the second, Pa.
void compare(const Curve& run, const Curve& fine, double& difference, double& peak) {
  for (std::size_t i = 0; i < run.stress.size(); ++i) {
    const double exact = stress_at(fine, static_cast<double>(i) / static_cast<double>(run.stress.size() - 1));
    // A mounted swatch reads nothing before its grips have moved.
    if (!std::isfinite(run.stress[i]) || !std::isfinite(exact)) continue;
    difference = std::max(difference, std::abs(run.stress[i] - exact));
    peak = std::max(peak, std::abs(exact));
  }
}

double stress_difference(const Measured& run, const Measured& fine) {
  if (run.curves.empty() || run.curves.size() != fine.curves.size()) return unknown;
  double most = 0, peak = 0;
  for (std::size_t i = 0; i < run.curves.size(); ++i) {
    if (run.curves[i].curve.stress.size() < 2 || fine.curves[i].curve.stress.size() < 2) return unknown;
    compare(run.curves[i].curve, fine.curves[i].curve, most, peak);
  }
  return peak > 0 ? most / peak : unknown;
}

/// After the motion that lays one upon the other best (Umeyama 1991).
double position_difference(const Measured& run, const Measured& fine) {
  if (run.yarn.cols() == 0 || run.yarn.cols() != fine.yarn.cols()) return unknown;
  // Matrices of no fixed size: with them GCC 12 does not warn of Eigen's own vectors.
  const Eigen::MatrixXd from = run.yarn, to = fine.yarn;
  const Eigen::Matrix4d motion = Eigen::umeyama(from, to, false);
  const Points moved = (motion.topLeftCorner<3, 3>() * run.yarn).colwise() + motion.topRightCorner<3, 1>().eval();
  return std::sqrt((moved - fine.yarn).colwise().squaredNorm().mean()) / fine.diameter;
}

}  // namespace

Measured measured(const Results& results) {
  Measured of;
  of.curves = stress_strain_curves(results);
  of.features = features(stress_strain(results));
  of.relaxed = results.relaxed;
  of.energy = elastic_energy(results);
  of.yarn = places_of(results);
  of.diameter = std::numeric_limits<double>::infinity();
  for (const Material& material : results.scene.fabric.materials)
    of.diameter = std::min(of.diameter, material.diameter);
  of.intact = results.topology.intact();
  return of;
}

bool rests_apart(const Errors& error) {
  constexpr double most = 0.05;
  return error[of_course_spacing] > most || error[of_wale_spacing] > most;
}

Errors difference(const Measured& run, const Measured& fine) {
  return {stress_difference(run, fine),
          relative(run.features.initial_stiffness, fine.features.initial_stiffness),
          relative(run.features.transition_strain, fine.features.transition_strain),
          relative(run.relaxed.course_spacing, fine.relaxed.course_spacing),
          relative(run.relaxed.wale_spacing, fine.relaxed.wale_spacing),
          relative(run.energy, fine.energy),
          position_difference(run, fine)};
}

}  // namespace wale
