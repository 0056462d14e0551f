#include "bench/peers/patch_study.hpp"

#include <memory>

#include "bench/peers/markdown.hpp"
#include "bench/peers/methods.hpp"
#include "bench/peers/patch.hpp"
#include "bench/peers/set_yarn.hpp"

namespace wale::peers {
namespace {

constexpr double ramp = 0.02, end = 0.12;  // s
constexpr double peers_drag = 0.01;        // k_g, kg/(m s); the force has a factor 2

/// What yarn remembers of how it was laid: how strongly it was bent; or its speeds and the sides of its bends as well.
enum class Memory { amount, side };

std::unique_ptr<World> world_of(const Fabric& fabric, Memory memory, double within, bool drag) {
  std::vector<EffectSpec> effects;
  if (memory == Memory::amount) effects = {Stretch{}, Bend{.rest = RestShape::as_laid}};
  effects.emplace_back(Contact{});
  if (drag) effects.emplace_back(Drag{peers_drag});
  auto world = std::make_unique<World>(fabric, effects, Schedule::ramp(0, 1, within), at_rest(fabric));
  if (memory == Memory::side) world->add(set_yarn(world->parts()));
  return world;
}

Row row(const Patch& patch, const Fabric& fabric, World& world, double tolerance, const Answer& answer) {
  const Vec3 size = 1e3 * extent(fabric, answer.state.q);
  double energy = 0;
  Load load{.energy = &energy};
  world.prepare(answer.state);
  world.evaluate(answer.state, load);
  return {fmt::format("{}", patch.segments_per_stitch),
          fmt::format("{:.0e}", tolerance),
          answer.failure.empty() ? fmt::format("{:.3f} x {:.3f} x {:.3f}", size.x(), size.y(), size.z())
                                 : fmt::format("none from load {:.2g}", answer.state.t),
          fmt::format("{:.2g}", 1e3 * off_shape(patch, fabric, answer.state.q)),
          fmt::format("{:.1e}", energy),
          fmt::format("{:.4f}", world.closest()),
          fmt::format("{}", answer.evaluations),
          fmt::format("{}", answer.factorizations),
          fmt::format("{:.2f}", answer.processor),
          fmt::format("{:.2f}", answer.wall)};
}

void print_title(const std::string& title) {
  fmt::print("\n{}\n\n", title);
  print_heading({"segments a stitch", "tolerance", "width x height x thickness, mm", "off Eq. (4), mm", "energy, J",
                 "closest, d", "evaluations", "factors", "processor s", "wall s"});
}

void rest(const Patch& patch, Memory memory, double tolerance) {
  const Fabric fabric = lay(patch);
  const auto world = world_of(fabric, memory, 1, false);
  const Answer answer = rest_by_quasi_static(*world, at_rest(fabric), 1, {.tolerance = tolerance});
  print_row(row(patch, fabric, *world, tolerance, answer));
}

void move(const Patch& patch, double tolerance) {
  const Fabric fabric = lay(patch);
  const auto world = world_of(fabric, Memory::side, ramp, true);
  const Accuracy accuracy{.relative = tolerance, .absolute = 1e-7, .absolute_speed = 1e-3};
  print_row(row(patch, fabric, *world, tolerance, move_by_cvode(*world, at_rest(fabric), end, accuracy)));
}

}  // namespace

void study_patch(int wales, int courses) {
  const auto patch = [&](int segments) {
    return Patch{.wales = wales, .courses = courses, .segments_per_stitch = segments};
  };
  print_title(fmt::format("{} x {} at rest, yarn that remembers the sides of its bends", wales, courses));
  for (const int segments : {8, 16, 24, 32, 64, 128}) rest(patch(segments), Memory::side, 1e-9);
  print_title(fmt::format("{} x {}, the same by tolerance", wales, courses));
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) rest(patch(24), Memory::side, tolerance);
  print_title(fmt::format("{} x {} at rest, yarn that remembers how strongly it was bent only", wales, courses));
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) rest(patch(32), Memory::amount, tolerance);
}

void move_patch(int wales, int courses) {
  print_title(fmt::format("{} x {} after {:g} s of motion by CVODE", wales, courses, end));
  for (const int segments : {16, 24, 32})
    move({.wales = wales, .courses = courses, .segments_per_stitch = segments}, 1e-2);
}

}  // namespace wale::peers
