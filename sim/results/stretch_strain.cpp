#include "sim/results/stretch_strain.hpp"

#include "sim/spline.hpp"

namespace wale {

std::vector<double> stretch_strains(const Fabric& fabric, const Points& q, const RestLengths& rest) {
  constexpr Basis middle = basis(0.5);
  std::vector<double> strains;
  for (int i = 0; i < fabric.segment_count(); ++i) {
    const double rest_length = rest.of(fabric.segment(i));
    strains.push_back(combine(q, fabric.first_point(i), middle.first).norm() / rest_length - 1);
  }
  return strains;
}

RestLengths rest_lengths_at(const Scene& scene, const Snapshot& snapshot) {
  if (scene.stages.empty()) return 1;
  const Stage& stage = scene.stages[static_cast<std::size_t>(snapshot.stage)];
  return rest_schedules(stage, rest_lengths_before(scene, snapshot.stage),
                        scene.fabric.materials.size())(snapshot.state.t);
}

}  // namespace wale
