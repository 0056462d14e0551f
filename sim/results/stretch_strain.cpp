#include "sim/results/stretch_strain.hpp"

#include "sim/spline.hpp"

namespace wale {

std::vector<double> stretch_strains(const Fabric& fabric, const Points& q, double tightening) {
  constexpr Basis middle = basis(0.5);
  std::vector<double> strains;
  for (int i = 0; i < fabric.segment_count(); ++i) {
    const Segment& of = fabric.segment(i);
    const double rest_length = of.length + (of.knitted - of.length) * tightening;
    strains.push_back(combine(q, fabric.first_point(i), middle.first).norm() / rest_length - 1);
  }
  return strains;
}

double tightening_at(const Scene& scene, const Snapshot& snapshot) {
  if (scene.stages.empty()) return 1;
  double share = 0;
  for (int i = 0; i < snapshot.stage; ++i) share = scene.stages[static_cast<std::size_t>(i)].tighten.value_or(share);
  const Stage& stage = scene.stages[static_cast<std::size_t>(snapshot.stage)];
  return Schedule::ramp(share, stage.tighten.value_or(share), stage.duration)(snapshot.state.t);
}

}  // namespace wale
