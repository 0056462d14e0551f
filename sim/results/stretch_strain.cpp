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

}  // namespace wale
