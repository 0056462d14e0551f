#include "sim/period_inertia.hpp"

namespace wale {
namespace {

constexpr double strip = 10;  // times the yarn's diameter

}  // namespace

PeriodInertia::PeriodInertia(const Fabric& fabric) {
  if (!fabric.cell) return;
  double mass = 0;
  for (int i = 0; i < fabric.segment_count(); ++i)
    mass += fabric.material_of(i).linear_density * fabric.segment(i).length;
  const double width = strip * fabric.materials.front().diameter;
  const Eigen::Array2d lengths(fabric.cell->course.x(), fabric.cell->wale.y());
  masses_ = mass / 12 * (width / lengths).square();
}

double PeriodInertia::kinetic_energy(const State& at, const PeriodGuide& guide) const {
  const Eigen::Matrix<double, 3, 2> rate = guide.mobility().cwiseProduct(at.v.rightCols<2>());
  return rate.colwise().squaredNorm().dot(masses_) / 2;
}

void PeriodInertia::add_to(Points& acceleration, const Points& force, const State& at, const PeriodGuide& guide,
                           const Mass& mass) const {
  const Eigen::Matrix<double, 3, 2> of_periods =
      guide.mobility().cwiseProduct(force_on_flow(force, at, mass)) * masses_.cwiseInverse().asDiagonal();
  acceleration += of_periods * in_periods(at.q, at);
}

}  // namespace wale
