/// `wale_peers`: other codes and other people's problems beside ours; see docs/peers.md.
#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>

#include "bench/peers/comparison.hpp"
#include "bench/peers/patch_study.hpp"

namespace {

struct Swatch {
  int wales = 4, courses = 4;
};

void add_sizes(CLI::App* command, Swatch& swatch) {
  command->add_option("--wales", swatch.wales, "stitches a row")->capture_default_str();
  command->add_option("--courses", swatch.courses, "rows")->capture_default_str();
}

}  // namespace

int main(int count, char** words) {
  using namespace wale::peers;
  omp_set_num_threads(1);
  CLI::App app("The problems of docs/peers.md, as Markdown tables");
  app.require_subcommand(1);
  Swatch swatch;
  double span = 1e-3, duration = 1, percent = 40;
  int samples = 8, segments = 24;
  bool gripped = false;

  CLI::App* patch = app.add_subcommand("patch", "the peers' patch, ramped to 95 % and relaxed");
  CLI::App* move_the_patch = app.add_subcommand("move-patch", "the same by implicit motion under the peers' drag");
  CLI::App* move =
      app.add_subcommand("move", "the motion of a swatch whose edges alone are held after it was tightened");
  CLI::App* relax = app.add_subcommand("relax", "rest of a swatch whose edges alone are held after it was tightened");
  CLI::App* pull = app.add_subcommand("pull", "rest of a swatch pulled along the wales to 40 %");
  CLI::App* cell = app.add_subcommand("cell", "the curve of a periodic cell of 2 x 2 stitches pulled along the wales");
  for (CLI::App* command : {patch, move_the_patch, move, relax, pull}) add_sizes(command, swatch);
  move->add_option("--span", span, "s")->capture_default_str();
  move->add_flag("--pull", gripped, "relaxed first, then pulled to 40 % within --duration");
  for (CLI::App* command : {pull, cell})
    command->add_option("--samples", samples, "load steps at least")->capture_default_str();
  cell->add_option("--to", percent, "%")->capture_default_str();
  cell->add_option("--segments", segments, "a stitch")->capture_default_str();
  for (CLI::App* command : {move, pull})
    command->add_option("--duration", duration, "of the pull where it is a motion, s")->capture_default_str();
  CLI11_PARSE(app, count, words);

  if (*patch) study_patch(swatch.wales, swatch.courses);
  if (*move_the_patch) move_patch(swatch.wales, swatch.courses);
  if (*move && gripped) compare_motion(*pulling(swatch.wales, swatch.courses, duration), "Pulled", span);
  if (*move && !gripped) compare_motion(*relaxing(swatch.wales, swatch.courses), "Let go", span);
  if (*relax) compare_rest(*relaxing(swatch.wales, swatch.courses), "Relaxed", 1);
  if (*pull) compare_rest(*pulling(swatch.wales, swatch.courses, duration), "Pulled to 40 %", samples);
  if (*cell) compare_curves(*pulling_cell(segments, percent), fmt::format("Cell pulled to {:g} %", percent), samples);
}
