#include "sim/deform.hpp"

#include <cmath>

namespace wale {
namespace {

/// How far a part moves in its leg `k`; what is not driven does not.
double leg(const Deform::Part& part, std::size_t k) {
  if (part.how != Deform::How::driven) return 0;
  return part.strains[k] - (k > 0 ? part.strains[k - 1] : 0);
}

/// Along the whole way of all three strains, how far it is to the end of each leg of `part`. Where only the curvature
/// changes, which begins anywhere, legs are alike.
std::vector<double> ways(const Deform& deform, const Deform::Part& part) {
  std::vector<double> ways{0};
  for (std::size_t k = 0; k < part.strains.size(); ++k) {
    const double strains = std::hypot(leg(deform.wale, k), leg(deform.course, k), leg(deform.shear, k));
    ways.push_back(ways.back() + (strains > 0 ? strains : 1));
  }
  return ways;
}

}  // namespace

Schedule strain_of(const Deform& deform, const Deform::Part& part, double duration) {
  const std::vector<double> way = ways(deform, part);
  std::vector<Schedule::Knot> knots{{0, 0}};
  for (std::size_t k = 0; k < part.strains.size(); ++k)
    knots.push_back({duration * way[k + 1] / way.back(), part.strains[k]});
  return Schedule(std::move(knots));
}

Schedule strain_of(const Pull& pull, double duration) {
  const Deform alone{.wale = {Deform::How::driven, pull.strains}};
  return strain_of(alone, alone.wale, duration);
}

std::vector<double> turns_of(const Stage& stage) {
  if (!stage.strains()) return {};
  const Deform deform = deform_of(stage);
  std::vector<double> times;
  for (const Deform::Part* part : {&deform.wale, &deform.course, &deform.shear, &deform.curl}) {
    if (part->how != Deform::How::driven) continue;
    const Schedule strain = strain_of(deform, *part, stage.duration);
    for (const Schedule::Knot& knot : strain.knots()) times.push_back(knot.t);
    break;  // all parts turn together
  }
  return times;
}

Deform deform_of(const Stage& stage) {
  if (stage.deform) return *stage.deform;
  Deform deform;
  if (stage.pull)
    (stage.pull->along == Along::wale ? deform.wale : deform.course) = {Deform::How::driven, stage.pull->strains};
  else if (stage.hold == Hold::periods)
    for (Deform::Part* part : {&deform.wale, &deform.course, &deform.shear, &deform.curl})
      part->how = Deform::How::held;
  return deform;
}

}  // namespace wale
