#include "studio/choice/scales.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace wale {
namespace {

constexpr double standard_gravity = 9.80665;  // m/s²

constexpr double least_share = 0.1;  // of all yarn: what binds edges off says nothing of a fabric

/// Knitted, m.
std::vector<double> length_by_material(const Fabric& fabric) {
  std::vector<double> lengths(fabric.materials.size());
  for (const Segment& segment : fabric.segments) lengths[static_cast<std::size_t>(segment.material)] += segment.knitted;
  return lengths;
}

/// Strains that a stage goes to, one list for each thing that it drives.
std::vector<std::vector<double>> driven(const Stage& stage) {
  std::vector<std::vector<double>> lists;
  if (stage.pull) lists.push_back(stage.pull->strains);
  if (stage.deform)
    for (const Deform::Part* part : {&stage.deform->wale, &stage.deform->course, &stage.deform->shear})
      lists.push_back(part->strains);
  return lists;
}

}  // namespace

Scales scales_of(const Fabric& fabric, int segments_per_stitch) {
  const std::vector<double> lengths = length_by_material(fabric);
  const double all = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  Scales of;
  of.stitch_length = segments_per_stitch * all / fabric.segment_count();
  of.diameter = of.bending_force = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (lengths[i] < least_share * all) continue;
    const Material& yarn = fabric.materials[i];
    of.diameter = std::min(of.diameter, yarn.diameter);
    of.bending_force = std::min(of.bending_force, yarn.bending_rigidity / (yarn.diameter * yarn.diameter));
    of.linear_density = std::max(of.linear_density, yarn.linear_density);
  }
  return of;
}

std::string words_of(const Scales& of) {
  return fmt::format(
      "{:.3g} mm of yarn a stitch, {:.3g} diameters; {:.3g} mN bend a yarn about another (EI/d²); a stitch "
      "weighs {:.2g} µN\n",
      1e3 * of.stitch_length, of.stitch_length / of.diameter, 1e3 * of.bending_force,
      1e6 * standard_gravity * of.linear_density * of.stitch_length);
}

double greatest_strain(const Stage& stage) {
  double most = 0;
  for (const auto& strains : driven(stage))
    for (const double strain : strains) most = std::max(most, std::abs(strain));
  return most;
}

double strain_path(const Stage& stage) {
  double longest = 0;
  for (const auto& strains : driven(stage)) {
    double path = 0, at = 0;
    for (const double strain : strains) path += std::abs(strain - std::exchange(at, strain));
    longest = std::max(longest, path);
  }
  return longest;
}

}  // namespace wale
