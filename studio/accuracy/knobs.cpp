#include "studio/accuracy/knobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/front/limits.hpp"
#include "studio/accuracy/adjust.hpp"

namespace wale {
namespace {

Rung rung(std::string label, double size, std::function<void(Scene&)> adjust) {
  return {std::move(label), size, {{}, std::move(adjust)}};
}

/// One rung for each factor; that of 1 is the scene as written.
template <class Make>
std::vector<Rung> scaled(const std::vector<double>& factors, Make make) {
  std::vector<Rung> rungs;
  for (const double factor : factors) {
    rungs.push_back(make(factor));
    rungs.back().as_written = factor == 1;
  }
  return rungs;
}

int segments_at(const ParsedScene& scene, double factor) {
  const int even = 2 * static_cast<int>(std::lround(scene.segments_per_stitch * factor / 2));
  return factor == 1 ? scene.segments_per_stitch : std::clamp(even, limits::least_segments, limits::most_segments);
}

Knob segments(const ParsedScene& scene) {
  Knob knob{"segments", "segments a stitch", Knob::Kind::resolution, 2};
  for (const double factor : {0.5, 0.67, 1.0, 1.33, 2.0}) {
    const int count = segments_at(scene, factor);
    if (!knob.rungs.empty() && knob.rungs.back().label == std::to_string(count)) continue;
    Rung rung{std::to_string(count), 1.0 / count, {}, factor == 1};
    rung.variant.changes.segments_per_stitch = count;
    knob.rungs.push_back(std::move(rung));
  }
  return knob;
}

template <class Effect>
Knob nodes(std::string key, std::string noun, int most, int written) {
  Knob knob{std::move(key), std::move(noun), Knob::Kind::choice};
  for (int count = 1; count <= most; ++count) {
    knob.rungs.push_back(rung(std::to_string(count), 1.0 / count, [count](Scene& scene) {
      for_each_effect<Effect>(scene, [&](Effect& effect) { effect.nodes = count; });
    }));
    knob.rungs.back().as_written = count == written;
  }
  return knob;
}

Knob sampling(double written) {
  Knob knob{"sampling", "of a diameter that a chain of contact beads may bulge", Knob::Kind::resolution, 1};
  knob.rungs = scaled({4, 2, 1, 0.5, 0.25}, [&](double factor) {
    return rung(fmt::format("{:.3g} %", 100 * written * factor), written * factor,
                [factor](Scene& scene) { scale_sampling(scene, factor); });
  });
  return knob;
}

Knob skin(double written) {
  Knob knob{"skin", "of a diameter beyond touching that near segments are listed", Knob::Kind::choice};
  knob.rungs = scaled({0.25, 0.5, 1, 2, 4}, [&](double factor) {
    return rung(fmt::format("{:.3g} %", 100 * written * factor), 0,
                [factor](Scene& scene) { scale_skin(scene, factor); });
  });
  return knob;
}

Knob law(ContactLaw written) {
  Knob knob{"law", "contact law", Knob::Kind::choice};
  for (const ContactLaw law : {ContactLaw::barrier, ContactLaw::quadratic, ContactLaw::core_shell}) {
    knob.rungs.push_back(rung(std::string(contact_law_names[static_cast<std::size_t>(law)]), 0, [law](Scene& scene) {
      for (Material& material : scene.fabric.materials) material.law = law;
    }));
    knob.rungs.back().as_written = law == written;
  }
  return knob;
}

Knob contact_stiffness(double written) {
  Knob knob{"contact_stiffness", "N/m of contact stiffness", Knob::Kind::choice};
  knob.rungs = scaled({0.25, 1, 4}, [&](double factor) {
    return rung(fmt::format("{:.3g}", written * factor), 1 / factor, [factor](Scene& scene) {
      for (Material& material : scene.fabric.materials) material.contact_stiffness *= factor;
    });
  });
  return knob;
}

Knob tolerance(std::string key, std::string noun, StageKind of) {
  Knob knob{std::move(key), std::move(noun), Knob::Kind::resolution, 1};
  knob.finds_rest = of == StageKind::at_rest;
  knob.rungs = scaled({10, 3, 1, 0.3, 0.1}, [&](double factor) {
    return rung(fmt::format("{:g} x", factor), factor,
                [factor, of](Scene& scene) { scale_tolerance(scene, of, factor); });
  });
  return knob;
}

Knob load_step(int samples) {
  Knob knob{"load_step", "load steps", Knob::Kind::resolution, 2};
  const bool halves = samples % 2 == 0 && samples >= 4;
  const std::vector<double> factors = halves ? std::vector<double>{0.5, 1, 2, 4} : std::vector<double>{1, 2, 4};
  knob.rungs = scaled(factors, [&](double factor) {
    return rung(fmt::format("{:.0f}", samples * factor), 1 / (samples * factor),
                [factor](Scene& scene) { scale_samples(scene, factor); });
  });
  return knob;
}

Knob friction_threshold(double written) {
  constexpr double mm_per_s = 1e3;
  Knob knob{"friction_threshold", "mm/s from which yarn slides", Knob::Kind::resolution, 1};
  knob.rungs = scaled({10, 3, 1, 0.3, 0.1}, [&](double factor) {
    return rung(fmt::format("{:.3g}", mm_per_s * written * factor), written * factor, [factor](Scene& scene) {
      for_each_effect<Friction>(scene, [&](Friction& friction) { friction.threshold *= factor; });
    });
  });
  return knob;
}

Knob grip_stiffness(double written) {
  Knob knob{"grip_stiffness", "N/m² of the grips", Knob::Kind::resolution, 1};
  knob.rungs = scaled({0.01, 0.1, 1, 10}, [&](double factor) {
    return rung(fmt::format("{:.3g}", written * factor), 1 / (written * factor), [factor](Scene& scene) {
      for (Stage& stage : scene.stages) stage.grip_stiffness *= factor;
    });
  });
  return knob;
}

/// Motion: what an integrator may err, how fast the pull is, what drags.
Knob step_error() {
  Knob knob{"step_error", "error a step", Knob::Kind::resolution, 1};
  knob.rungs = scaled({10, 3, 1, 0.3}, [&](double factor) {
    return rung(fmt::format("{:g} x", factor), factor, [factor](Scene& scene) { scale_step_error(scene, factor); });
  });
  return knob;
}
Knob pull_rate() {
  Knob knob{"pull_rate", "speed of the pull", Knob::Kind::resolution, 1};
  knob.rungs = scaled({4, 2, 1, 0.5}, [&](double factor) {
    return rung(fmt::format("{:g} x", factor), factor, [factor](Scene& scene) { scale_duration(scene, 1 / factor); });
  });
  return knob;
}
Knob drag() {
  Knob knob{"drag", "drag", Knob::Kind::choice};
  knob.rungs = scaled({4, 1, 0.25}, [&](double factor) {
    return rung(fmt::format("{:g} x", factor), factor, [factor](Scene& scene) {
      for_each_effect<Drag>(scene, [&](Drag& effect) { effect.coefficient *= factor; });
    });
  });
  return knob;
}

Rung sized(int wales, int courses) {
  Rung rung{fmt::format("{} x {}", wales, courses), 1.0 / wales};
  rung.variant.changes.wales = wales;
  rung.variant.changes.courses = courses;
  return rung;
}

/// A swatch has edges, and grows towards the fabric without end; of a cell, whether its stitches do all alike.
Knob size(const Gauge& gauge, bool periodic) {
  Knob knob{"size", periodic ? "stitches in a repeat" : "wales x courses", Knob::Kind::choice, {}, {}, !periodic};
  const auto times = [&](double factor) {
    return sized(static_cast<int>(std::lround(gauge.wales * factor)),
                 static_cast<int>(std::lround(gauge.courses * factor)));
  };
  if (!periodic) knob.rungs.push_back(times(0.5));
  knob.rungs.push_back(times(1));
  knob.rungs.back().as_written = true;
  knob.rungs.push_back(times(2));
  if (periodic) return knob;
  Rung cell = sized(2, 2);
  cell.label = "without end";
  cell.variant.changes.periodic = true;
  cell.variant.adjust = take_edges_off;
  knob.rungs.push_back(std::move(cell));
  return knob;
}

Knob solver() {
  Knob knob{"solver", "solver of the pull", Knob::Kind::choice, {}, {}, true};
  knob.rungs.push_back(rung("runge_kutta in 5 ms", 0, [](Scene& scene) { pull_in_motion(scene, 5e-3, RungeKutta{}); }));
  knob.rungs.push_back(
      rung("runge_kutta in 10 ms", 0, [](Scene& scene) { pull_in_motion(scene, 10e-3, RungeKutta{}); }));
  knob.rungs.push_back(rung("implicit in 10 ms", 0, [](Scene& scene) { pull_in_motion(scene, 10e-3, Implicit{}); }));
  knob.rungs.push_back({"quasi_static", 0, {}, true});
  return knob;
}

bool is_static(const Stage& stage) { return std::holds_alternative<QuasiStatic>(stage.solver); }

/// Those that have a meaning for a scene's stages.
void append_knobs_of_stages(const Scene& scene, std::vector<Knob>& knobs) {
  const Stage* strained = last_strained_stage(scene);
  const bool moves =
      std::any_of(scene.stages.begin(), scene.stages.end(), [](const Stage& each) { return !is_static(each); });
  if (strained && is_static(*strained)) {
    knobs.push_back(tolerance("tolerance", "the tolerance of the pull", StageKind::strained));
    knobs.push_back(load_step(strained->samples));
  }
  knobs.push_back(tolerance("rest_tolerance", "the tolerance at rest", StageKind::at_rest));
  if (const Friction* friction = find_effect<Friction>(scene)) knobs.push_back(friction_threshold(friction->threshold));
  if (!scene.fabric.cell && strained) knobs.push_back(grip_stiffness(strained->grip_stiffness));
  if (moves) {
    knobs.push_back(step_error());
    if (strained && !is_static(*strained)) knobs.push_back(pull_rate());
    if (find_effect<Drag>(scene)) knobs.push_back(drag());
  } else if (!scene.fabric.cell && strained) {
    knobs.push_back(solver());
  }
}

}  // namespace

std::vector<Knob> knobs_of(const ParsedScene& parsed, const Scene& scene, bool of_chart) {
  std::vector<Knob> knobs{segments(parsed)};
  if (const Stretch* effect = find_effect<Stretch>(scene))
    knobs.push_back(nodes<Stretch>("stretch_nodes", "nodes a segment for stretch", 3, effect->nodes));
  if (const Bend* effect = find_effect<Bend>(scene))
    knobs.push_back(nodes<Bend>("bend_nodes", "nodes a segment for bending", 4, effect->nodes));
  if (const Contact* effect = find_effect<Contact>(scene)) {
    knobs.push_back(sampling(effect->sampling));
    knobs.push_back(skin(effect->skin));
    knobs.push_back(law(scene.fabric.materials.front().law));
    knobs.push_back(contact_stiffness(scene.fabric.materials.front().contact_stiffness));
  }
  append_knobs_of_stages(scene, knobs);
  if (of_chart) knobs.push_back(size(scene.gauge, scene.fabric.cell.has_value()));
  return knobs;
}

Knob all_together(const ParsedScene& parsed) {
  struct Level {
    double segments, sampling, tolerance, samples;
  };
  constexpr Level levels[] = {{0.5, 4, 4, 0.5},    {0.67, 2, 2, 1},    {1, 1, 1, 1},
                              {1.33, 0.5, 0.5, 1}, {2, 0.25, 0.25, 2}, {3, 0.125, 0.1, 4}};
  Knob knob{"together", "segments a stitch, all else likewise", Knob::Kind::resolution, 2};
  for (const Level& level : levels) {
    const int count = segments_at(parsed, level.segments);
    Rung rung{std::to_string(count), 1.0 / count};
    rung.as_written = level.segments == 1;
    rung.variant.changes.segments_per_stitch = count;
    rung.variant.adjust = [level](Scene& scene) {
      scale_sampling(scene, level.sampling);
      scale_tolerance(scene, StageKind::strained, level.tolerance);
      scale_samples(scene, level.samples);
      scale_step_error(scene, level.tolerance);
    };
    knob.rungs.push_back(std::move(rung));
  }
  return knob;
}

}  // namespace wale
