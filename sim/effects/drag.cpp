#include "sim/effects/along_yarn.hpp"
#include "sim/periods.hpp"

namespace wale {
namespace {

struct DragEffect {
  using Slopes = DragLaw;
  double k_g;
  std::string_view name() const { return "drag"; }
  DragLaw slopes(double) const { return {k_g}; }
  double constant(const Material&) const { return 0; }
  void curvature(const Slopes&, const Site<double>& at, Curvature& out, bool) const {
    out.v_v = 2 * k_g * at.l * Mat3::Identity();
  }
};

/// The air around an endless fabric flows with its periods: still air would hold one repeat back otherwise than the
/// next. The second slopes by the periods are left out: a solver that moves these needs a few more iterations.
class DragInFlow final : public Effect {
 public:
  explicit DragInFlow(std::unique_ptr<Effect> drag) : drag_(std::move(drag)) {}

  std::string_view name() const override { return drag_->name(); }
  bool dissipative() const override { return true; }

  void add(const State& at, Load& out) const override {
    State beside = at;
    beside.v = beside_flow(at);
    Points force = Points::Zero(3, at.q.cols());
    Load load = out;
    if (out.force) load.force = &force;
    drag_->add(beside, load);
    if (!out.force) return;
    *out.force += force;
    out.force->rightCols<2>() -= force * in_periods(at.q, at).transpose();
  }

 private:
  std::unique_ptr<Effect> drag_;
};

}  // namespace

std::unique_ptr<Effect> make(const Drag& spec, Parts& parts) {
  // Four nodes integrate v·v exactly, so that a free yarn slows by one exponential.
  auto drag = std::make_unique<AlongYarn<DragEffect>>(DragEffect{spec.coefficient}, parts, 4,
                                                      segments_of(parts.fabric, spec.on));
  if (parts.fabric.cell) return std::make_unique<DragInFlow>(std::move(drag));
  return drag;
}

}  // namespace wale
