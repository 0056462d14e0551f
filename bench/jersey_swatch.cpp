#include "bench/jersey_swatch.hpp"

#include "compiler/compile.hpp"

namespace wale {

JerseySwatch::JerseySwatch(int wales, int courses, double shrinkage, Mounting mounting) {
  const Source chart{"jersey.yaml", "knit: 1\nbands: [{stitch: jersey, courses: 13}]\nwales: 12\n"};
  Diagnostics say;
  const auto scene =
      compile_chart(chart, {.wales = wales, .courses = courses, .stitch_length = 7.23e-3, .materials = {}}, 12, say);
  fabric_ = scene->fabric;
  state_ = at_rest(fabric_);
  state_.q *= shrinkage;
  std::vector<EffectSpec> effects{Stretch{}, Bend{}, Contact{}};
  if (mounting == Mounting::gripped) {
    effects.emplace_back(Plates{});
    for (const std::vector<int>& end : scene->gauge.wale_ends)
      effects.emplace_back(Tether{.segments = end, .stiffness = 1e4});
  }
  world_ = std::make_unique<World>(fabric_, std::move(effects), Schedule(1.0), state_);
}

double JerseySwatch::evaluate() {
  double energy = 0;
  Load load{.energy = &energy, .force = &force_};
  world_->prepare(state_);
  world_->evaluate(state_, load);
  return energy;
}

}  // namespace wale
