#include <cmath>

#include "sim/parts.hpp"
#include "sim/spline.hpp"

namespace wale {
namespace {

/// k (|y_a - y_b| - r0)² for each knot: two points of yarn tied at a distance.
class KnotsEffect final : public Effect {
 public:
  KnotsEffect(Knots spec, const Parts& parts) : spec_(std::move(spec)), fabric_(parts.fabric) {}

  std::string_view name() const override { return "knots"; }

  void add(const State& at, Load& out) const override {
    for (const Knot& knot : spec_.knots) add_knot(knot, at, out);
  }

 private:
  void add_knot(const Knot& knot, const State& at, Load& out) const {
    const int first[2] = {fabric_.first_point(knot.segment_a), fabric_.first_point(knot.segment_b)};
    const Basis ba = basis(knot.s_a), bb = basis(knot.s_b);
    const Vec3 apart = combine(at.q, first[0], ba.value) - combine(at.q, first[1], bb.value);
    const double distance = apart.norm(), slack = distance - knot.length, k = spec_.stiffness;
    const Vec3 n = apart / distance;
    if (out.energy) *out.energy += k * slack * slack;
    std::array<double, 8> weight;
    for (std::size_t i = 0; i < 4; ++i) {
      weight[i] = ba.value[i];
      weight[i + 4] = -bb.value[i];
    }
    const auto point = [&](std::size_t i) { return first[i / 4] + static_cast<int>(i % 4); };
    if (out.force)
      for (std::size_t i = 0; i < 8; ++i) out.force->col(point(i)) -= 2 * k * slack * weight[i] * n;
    const Mat3 along = n * n.transpose(), sideways = (Mat3::Identity() - along) / distance;
    const auto add_second = [&](Stiffness* to, const Mat3& second) {
      if (!to) return;
      for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t j = i; j < 8; ++j) {
          const int p = point(i), q = point(j);
          const double share = (p == q && i != j ? 2 : 1) * weight[i] * weight[j];
          to->add(std::min(p, q), std::max(p, q), share * second);
        }
    };
    add_second(out.stiffness, 2 * k * (along + slack * sideways));
    add_second(out.convex, 2 * k * (along + std::max(slack, 0.0) * sideways));
  }

  Knots spec_;
  const Fabric& fabric_;
};

}  // namespace

std::unique_ptr<Effect> make(const Knots& spec, Parts& parts) { return std::make_unique<KnotsEffect>(spec, parts); }

}  // namespace wale
