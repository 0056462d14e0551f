#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "compiler/compile.hpp"
#include "tests/stability/hard_case.hpp"

namespace wale::stability {
namespace {

/// `pattern` is one that is no file.
HardScene compiled(const std::string& text, int first_tested, const Source& pattern = {}) {
  Sources sources;
  Diagnostics say;
  if (!pattern.text.empty()) sources.add(WALE_SOURCE_DIR "/patterns/" + pattern.name, pattern.text);
  const Source* source = sources.add(WALE_SOURCE_DIR "/patterns/stability.scene.yaml", text);
  auto scene = compile_scene(*source, sources, say);
  if (!scene || say.failed()) throw std::runtime_error("a scene of the hard cases does not compile:\n" + text);
  HardScene hard;
  hard.scene = std::move(*scene);
  hard.first_tested = first_tested;
  return hard;
}

/// 2 x 2 stitches of an endless fabric, whose loops are pulled tight before it is tested.
HardScene cell(const std::string& stages, int first_tested = 2, const std::string& pattern = "jersey") {
  return compiled("scene: 1\nfabric: {pattern: " + pattern +
                      ".yaml, wales: 2, courses: 2, periodic: true, segments_per_stitch: 12}\n"
                      "effects: {stretch: , bend: , contact: }\nsolver: {quasi_static: {tolerance: 0.02}}\nstages:\n"
                      "  - {name: tighten, duration: 1 s, tighten: 100 %, samples: 4}\n"
                      "  - {name: relax, duration: 1 s, samples: 1}\n" +
                      stages,
                  first_tested);
}

/// The loop length over the diameter; `loops` are tightened to it.
HardScene cell_of(double loop_over_diameter) {
  HardScene hard = cell("", 0);
  const double loop = loop_over_diameter * hard.scene.fabric.materials.front().diameter;
  for (Segment& segment : hard.scene.fabric.segments) segment.knitted *= loop / 7.23e-3;
  return hard;
}

/// What is knitted is so many percent of what is laid.
HardScene shrunk(double percent) {
  HardScene hard = cell("", 0);
  for (Segment& segment : hard.scene.fabric.segments) segment.knitted = percent / 100 * segment.length;
  return hard;
}

HardScene pulled_cell(const std::string& how, double percent, int samples) {
  return cell(fmt::format("  - {{name: pull, duration: 1 s, samples: {}, {}}}\n", samples,
                          fmt::format(fmt::runtime(how), percent)));
}
HardScene along_wales(double percent) { return pulled_cell("pull: {{along: wale, to: {} %}}", percent, 40); }
HardScene along_courses(double percent) { return pulled_cell("pull: {{along: course, to: {} %}}", percent, 40); }
HardScene in_one_step(double percent) { return pulled_cell("pull: {{along: wale, to: {} %}}", percent, 1); }
HardScene bias(double percent) { return pulled_cell("deform: {{shear: {} %}}", percent, 40); }

/// A swatch that is tightened and laid flat before it is tested.
HardScene swatch(int wales, int courses, const std::string& stages, const std::string& pattern = "jersey") {
  return compiled(
      fmt::format("scene: 1\nfabric: {{pattern: {}.yaml, wales: {}, courses: {}, segments_per_stitch: 10}}\n"
                  "effects: {{stretch: , bend: , contact: , knots: , drag: }}\n"
                  "solver: {{quasi_static: {{tolerance: 0.3}}}}\nstages:\n"
                  "  - {{name: tighten, duration: 1 s, samples: 2, tighten: 100 %, hold: ends,"
                  " effects: {{plates: {{gap: 1.2 mm}}}}, solver: {{quasi_static: {{tolerance: 1}}}}}}\n"
                  "  - {{name: relax, duration: 1 s, samples: 1, effects: {{plates: {{gap: 1.2 mm}}}}}}\n",
                  pattern, wales, courses) +
          stages,
      2);
}

HardScene pulled_swatch(int wales, int courses, double percent) {
  return swatch(
      wales, courses,
      fmt::format("  - {{name: pull, duration: 0.5 ms, samples: 10, pull: {{along: wale, to: {} %}}}}\n", percent));
}
HardScene small_swatch(double percent) { return pulled_swatch(3, 3, percent); }
HardScene one_wale(double courses) { return pulled_swatch(1, static_cast<int>(courses), 10); }
HardScene one_course(double wales) { return pulled_swatch(static_cast<int>(wales), 1, 10); }

/// Pulled to so many percent, then let go; friction keeps its edges from coming undone.
HardScene let_go(double percent) {
  HardScene hard = swatch(
      4, 4,
      fmt::format(
          "  - {{name: pull, duration: 1 s, samples: 10, pull: {{along: wale, to: {} %}}, effects: {{friction: }}}}\n"
          "  - {{name: let go, duration: 0.5 ms, samples: 20, effects: {{friction: {{threshold: 10 mm/s}}}}}}\n",
          percent));
  hard.first_tested = 3;
  hard.only_loses = true;
  return hard;
}

/// The yarn of a pulled swatch is cut at so many percent of its length, and that is let go.
HardScene cut(double percent) {
  HardScene hard = let_go(20);
  Fabric& fabric = hard.scene.fabric;
  const Yarn whole = fabric.yarns.front();
  const int before = static_cast<int>(percent / 100 * whole.segments);
  Points points(3, fabric.points.cols() + 3);
  points << fabric.points.leftCols(before + 3), fabric.points.rightCols(fabric.points.cols() - before);
  fabric.points = points;
  fabric.yarns.front().segments = before;
  fabric.yarns.insert(fabric.yarns.begin() + 1, {before + 3, before, whole.segments - before});
  for (std::size_t i = static_cast<std::size_t>(before); i < fabric.segments.size(); ++i) ++fabric.segments[i].yarn;
  hard.scene.crossings.clear();
  return hard;
}

/// Held at both ends and hung in so many times its weight.
HardScene heavy(double times) {
  HardScene hard = swatch(4, 4, "  - {name: hang, duration: 1 ms, samples: 10, hold: ends, effects: {gravity: }}\n");
  for (EffectSpec& effect : hard.scene.stages.back().effects)
    if (auto* gravity = std::get_if<Gravity>(&effect)) gravity->acceleration *= times;
  return hard;
}

/// Laid free, so that it curls at its edges, and then pressed between two planes that come as near as this: on the way
/// its edges snap over.
HardScene pressed(double millimetres) {
  constexpr double far = 8;  // mm
  const double way = far - millimetres / 2;
  HardScene hard = swatch(
      5, 4,
      fmt::format(
          "  - {{name: curl, duration: 1 s, samples: 1, effects: {{plates: {{gap: 100 mm}}, friction: }}}}\n"
          "  - name: press\n    duration: 5 ms\n    samples: 20\n    effects:\n"
          "      friction: {{threshold: 10 mm/s}}\n      obstacle:\n"
          "        - {{plane: {{point: [0 mm, 0 mm, {0} mm], normal: [0, 0, -1]}}, move: [0 mm, 0 mm, -{1} mm]}}\n"
          "        - {{plane: {{point: [0 mm, 0 mm, -{0} mm], normal: [0, 0, 1]}}, move: [0 mm, 0 mm, {1} mm]}}\n",
          far, way));
  hard.first_tested = 3;
  return hard;
}

/// A loop that is slipped over two courses, and all pulled along the wales until it takes the load, and lets it go to
/// its neighbours.
std::string slipped() {
  constexpr int wales = 3, courses = 5, held = 1, first = 2, last = 3;
  std::string text = ";!knitout-2\n;;Carriers: 1\nin 1\ntuck - f2 1\ntuck - f0 1\ntuck + f1 1\n";
  for (int course = 0; course < courses; ++course)
    for (int k = 0; k < wales; ++k) {
      const bool back = course % 2 == 0;
      const int needle = back ? wales - 1 - k : k;
      const bool slips = needle == held && course >= first && course <= last;
      text += fmt::format("{} {} f{} 1\n", slips ? "miss" : "knit", back ? '-' : '+', needle);
    }
  return text + "out 1\n";
}

HardScene slip_stitch(double percent) {
  return compiled(
      fmt::format("scene: 1\nfabric: {{pattern: slipped.k, segments_per_stitch: 12}}\n"
                  "effects: {{stretch: , bend: , contact: , knots: , drag: , friction: {{threshold: 10 mm/s}}}}\n"
                  "solver: {{quasi_static: {{tolerance: 0.3}}}}\nstages:\n"
                  "  - {{name: tighten, duration: 1 s, samples: 4, tighten: 100 %, hold: ends}}\n"
                  "  - {{name: relax, duration: 1 s, samples: 1}}\n"
                  "  - {{name: pull, duration: 0.5 ms, samples: 10, pull: {{along: wale, to: {} %}}}}\n",
                  percent),
      2, {"slipped.k", slipped()});
}

}  // namespace

std::vector<HardCase> cases_of_fabrics() {
  const std::vector<SolverKind> still{SolverKind::quasi_static};
  return {
      {"loop length over diameter", "", {14}, {25, 20, 16, 14, 13, 12, 11, 10, 9, 8, 7, 6}, cell_of, still},
      {"knitted over laid length", "%", {70}, {100, 90, 80, 70, 60, 55, 50, 45, 40}, shrunk, still},
      {"cell pulled along its wales", "%", {100}, {50, 100, 150, 200, 250, 300}, along_wales, still},
      {"cell pulled along its courses", "%", {100}, {50, 100, 150, 200, 250, 300}, along_courses, still},
      {"cell pulled in one step", "%", {40}, {10, 20, 40, 80, 120, 160, 200, 300}, in_one_step, still},
      {"cell sheared", "%", {40}, {20, 40, 60, 80, 100, 150, 200, 300}, bias, still},
      {"swatch pulled", "%", {20}, {20, 40, 80, 120, 160, 200, 300}, small_swatch},
      {"one wale of many courses", "courses", {4}, {1, 2, 3, 5, 10, 20}, one_wale},
      {"one course of many wales", "wales", {1}, {1, 2, 3, 5, 10, 20}, one_course},
      {"swatch let go", "%", {20}, {10, 20, 40, 80, 120}, let_go},
      {"swatch with a yarn cut", "% of its length", {50}, {10, 50, 90}, cut},
      {"swatch under its weight", "times", {1000}, {10, 100, 1000, 1e4, 1e5}, heavy},
      {"curled swatch pressed flat", "mm apart", {4}, {8, 4, 3, 2, 1.5, 1.2, 1, 0.8}, pressed, still},
      {"slip stitch that takes the load", "%", {20}, {10, 20, 40, 60, 80, 120}, slip_stitch},
  };
}

}  // namespace wale::stability
