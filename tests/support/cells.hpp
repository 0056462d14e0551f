/// Periodic fabrics by their repeats, and what is done to them.
#pragma once

#include <stdexcept>

#include "compiler/compile.hpp"
#include "sim/run.hpp"
#include "tests/support/make_chart.hpp"

namespace wale {

/// A repeat drawn as make_chart() does, and how its crossings lie.
inline CompiledChart compile_repeat(const std::vector<std::string>& picture, int segments_per_stitch) {
  Chart chart = make_chart(picture);
  chart.periodic = true;
  Diagnostics say;
  auto made = compile_chart(std::move(chart), segments_per_stitch, say);
  if (!made) throw std::runtime_error("the repeat was refused");
  return std::move(*made);
}

struct CellRun {
  std::vector<std::string> picture{"kk", "kk"};
  int segments_per_stitch = 12;
  double friction = 0;      ///< coefficient; 0: none
  double tolerance = 1e-3;  ///< of QuasiStatic
  Curls curls = Curls::never;
};

/// Tightens and relaxes a repeat, flat until then if that is `flat_before`, and does `last` to it. Throws
/// std::runtime_error with the reason if that fails.
inline Results run_cell(const CellRun& of, Stage last, bool flat_before = false) {
  CompiledChart made = compile_repeat(of.picture, of.segments_per_stitch);
  Results results;
  Scene& scene = results.scene;
  scene.fabric = std::move(made.fabric);
  scene.fabric.cell->curls = of.curls;
  scene.gauge = std::move(made.gauge);
  scene.crossings = std::move(made.crossings);
  Stage tighten, relax;
  tighten.tighten = 1.0;
  tighten.samples = 2;
  relax.samples = 1;
  if (flat_before)
    for (Stage* stage : {&tighten, &relax}) stage->deform = Deform{.curl = {Deform::How::held, {}}};
  scene.stages = {tighten, relax, std::move(last)};
  scene.gauge.thickness = 1.048e-3;
  for (Stage& stage : scene.stages) {
    stage.effects = {Stretch{}, Bend{}, Contact{}};
    if (of.friction > 0) stage.effects.push_back(Friction{.coefficient = of.friction});
    stage.solver = QuasiStatic{.tolerance = of.tolerance};
  }
  if (run(results, {}) != Outcome::finished) throw std::runtime_error(results.effort.failure);
  return results;
}

}  // namespace wale
