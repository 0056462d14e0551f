#include "bench/peers/problem.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "compiler/compile.hpp"
#include "sim/results/curves.hpp"
#include "sim/run.hpp"

namespace wale::peers {
namespace {

constexpr double peers_drag = 0.01;  // k_g, kg/(m s); the force has a factor 2

Scene scene_from(const std::string& text) {
  Sources sources;
  Diagnostics say;
  const auto scene = compile_scene(*sources.add(WALE_SOURCE_DIR "/bench/peers/scene.yaml", text), sources, say);
  if (!scene) throw std::runtime_error(print(say.all().front()));
  return *scene;
}

Scene scene_of(int wales, int courses, const std::string& last_stages) {
  return scene_from(fmt::format(R"(scene: 1
fabric: {{pattern: ../../patterns/jersey.yaml, wales: {}, courses: {}, stitch_length: 7.23 mm}}
effects: {{stretch: , bend: , contact: , knots: }}
stages:
  - {{name: tighten, tighten: 100 %, hold: ends, duration: 1 s, samples: 2,
      solver: {{quasi_static: {{tolerance: 1, first_step: 2 %}}}}}}
{})",
                                wales, courses, last_stages));
}

}  // namespace

Problem::Problem(Scene scene) : scene_(std::move(scene)) {
  Results before;
  before.scene = scene_;
  before.scene.stages.pop_back();
  if (run(before, {}) != Outcome::finished) throw std::runtime_error(before.effort.failure);
  start_ = before.snapshots.back().state;
  start_.t = start_.step = 0;
  start_.v.setZero();
  damped_ = stage();
  damped_.effects.emplace_back(Drag{peers_drag});
  const Sizes relaxed = wale::measure(scene_.fabric, scene_.gauge, start_.q);
  constexpr double tightened = 1;
  still_ = std::make_unique<StageSetup>(scene_, stage(), start_, tightened, relaxed);
  moving_ = std::make_unique<StageSetup>(scene_, damped_, start_, tightened, relaxed);
}

std::unique_ptr<World> Problem::still() const { return still_->world(); }
std::unique_ptr<World> Problem::moving() const { return moving_->world(); }

Quantity Problem::asked_of(const State& state) const {
  const auto world = still();
  if (!stage().pull) {
    double energy = 0;
    Load load{.energy = &energy};
    world->prepare(state);
    world->evaluate(state, load);
    return {"energy", "J", energy};
  }
  for (const Quantity& quantity : still_->measure(*world, state))
    if (quantity.name == "force") return quantity;
  throw std::logic_error("a pull has a force");
}

std::unique_ptr<Problem> relaxing(int wales, int courses) {
  return std::make_unique<Problem>(scene_of(wales, courses, "  - {name: relax, hold: ends, duration: 1 s}\n"));
}

std::unique_ptr<Problem> pulling(int wales, int courses, double duration) {
  return std::make_unique<Problem>(
      scene_of(wales, courses,
               fmt::format("  - {{name: relax, duration: 1 s, samples: 1, effects: {{plates: {{gap: 1.2 mm}}}},\n"
                           "     solver: {{quasi_static: {{tolerance: 0.3}}}}}}\n"
                           "  - {{name: pull, duration: {} s, pull: {{along: wale, to: 40 %}}, "
                           "effects: {{plates: {{gap: 1.2 mm}}}}}}\n",
                           duration)));
}

std::unique_ptr<Problem> pulling_cell(int segments_per_stitch, double percent) {
  return std::make_unique<Problem>(scene_from(fmt::format(R"(scene: 1
fabric: {{pattern: ../../patterns/jersey.yaml, wales: 2, courses: 2, periodic: true, segments_per_stitch: {}}}
effects: {{stretch: , bend: , contact: }}
stages:
  - {{name: tighten, tighten: 100 %, duration: 1 s, samples: 10}}
  - {{name: relax, duration: 1 s, samples: 1, solver: {{quasi_static: {{tolerance: 1e-4}}}}}}
  - {{name: pull, duration: 1 s, pull: {{along: wale, to: {} %}}}}
)",
                                                          segments_per_stitch, percent)));
}

}  // namespace wale::peers
